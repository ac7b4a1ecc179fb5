# SPDX-License-Identifier: Apache-2.0
"""Passes connections on to a server, and writes what each client has sent: recording_proxy.py PORT SERVER_PORT FOLDER."""
import pathlib
import socket
import sys
import threading


def pass_on(source, target, record):
    while data := source.recv(65536):
        if record:
            record.write(data)
            record.flush()
        target.sendall(data)
    try:
        target.shutdown(socket.SHUT_WR)
    except OSError:  # it has ended too
        pass


def main(port, server_port, folder):
    folder.mkdir(parents=True, exist_ok=True)
    listener = socket.create_server(("127.0.0.1", port))
    print("recording", flush=True)
    number = 0
    while True:
        client, _ = listener.accept()
        server = socket.create_connection(("127.0.0.1", server_port))
        number += 1
        record = open(folder / f"{number:02}.request", "wb")
        threading.Thread(target=pass_on, args=(client, server, record), daemon=True).start()
        threading.Thread(target=pass_on, args=(server, client, None), daemon=True).start()


main(int(sys.argv[1]), int(sys.argv[2]), pathlib.Path(sys.argv[3]))
