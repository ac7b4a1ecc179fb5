#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""front_end.py PORT FILE: prints a file through Moonraker's API as a front end does, with a pause. Status 0: all went well."""

import http.client
import itertools
import json
import sys
import time

from websockets.sync.client import connect

PATIENCE = 300  # seconds, on a machine under load


class FrontEnd:
    def __init__(self, port):
        self.socket = connect(f"ws://127.0.0.1:{port}/websocket", origin=f"http://127.0.0.1:{port}")
        self.numbers = itertools.count(1)
        self.status = {}
        self.heard = []

    def take(self, limit):
        message = json.loads(self.socket.recv(timeout=max(0, limit - time.monotonic())))
        if message.get("method") == "notify_status_update":
            for name, fields in message["params"][0].items():
                self.status[name].update(fields)
        elif "method" in message:
            self.heard.append(message)
        return message

    def call(self, method, **params):
        number = next(self.numbers)
        self.socket.send(json.dumps({"jsonrpc": "2.0", "method": method, "params": params, "id": number}))
        limit = time.monotonic() + PATIENCE
        while True:
            message = self.take(limit)
            if message.get("id") == number:
                if "error" in message:
                    sys.exit(f"{method}: {message['error']}")
                return message["result"]

    def wait(self, fits, what):
        limit = time.monotonic() + PATIENCE
        while not fits():
            try:
                self.take(limit)
            except TimeoutError:
                sys.exit(f"{what}: {self.status}")

    def state(self):
        return self.status["print_stats"]["state"]


def upload(port, name, text):
    border = "a-border-that-is-in-no-file"
    parts = [f'--{border}\r\nContent-Disposition: form-data; name="root"\r\n\r\ngcodes\r\n',
             f'--{border}\r\nContent-Disposition: form-data; name="file"; filename="{name}"\r\n'
             f'Content-Type: application/octet-stream\r\n\r\n{text}\r\n--{border}--\r\n']
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
    connection.request("POST", "/server/files/upload", "".join(parts),
                       {"Content-Type": f"multipart/form-data; boundary={border}"})
    answer = connection.getresponse()
    if answer.status != 201:
        sys.exit(f"upload: {answer.status} {answer.read()}")


def main(port, file):
    client = FrontEnd(port)
    client.call("server.connection.identify", client_name="test", version="1", type="web", url="http://localhost/")
    objects = {name: None for name in client.call("printer.objects.list")["objects"]}
    client.status = client.call("printer.objects.subscribe", objects=objects)["status"]
    client.wait(lambda: client.status["webhooks"]["state"] == "ready", "not ready")
    with open(file, encoding="ascii") as stream:
        upload(port, "part.gcode", stream.read())
    client.wait(lambda: any(each["method"] == "notify_filelist_changed" for each in client.heard), "no notice of the file")
    client.call("printer.print.start", filename="part.gcode")
    client.wait(lambda: "BED_CLEAR" in client.status["display_status"]["message"], "no message about what is awaited")
    client.call("printer.gcode.script", script="BED_CLEAR")
    client.wait(lambda: client.status["virtual_sdcard"]["progress"] > 0.2, "no progress")
    client.call("printer.print.pause")
    client.wait(lambda: client.state() == "paused", "not paused")
    paused_at = client.status["virtual_sdcard"]["progress"]
    if not 0.2 < paused_at < 0.9:
        sys.exit(f"paused at {paused_at}: too late to show anything")
    client.call("printer.print.resume")
    client.wait(lambda: client.state() == "complete", "not complete")
    if client.status["virtual_sdcard"]["progress"] != 1:
        sys.exit(f"complete, but: {client.status['virtual_sdcard']}")
    client.socket.close()


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2])
