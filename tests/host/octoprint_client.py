# SPDX-License-Identifier: Apache-2.0
"""Debian's client of OctoPrint's API (pyoctoprintapi) with a spooler: octoprint_client.py PORT PATH KEY.

PATH is `/` or that of a printer. Its printer is ready and prints a long job; each check ends the program where it fails.
"""
import asyncio
import sys

from pyoctoprintapi import ApiError, OctoprintClient, PrinterOffline
from pyoctoprintapi.exceptions import UnauthorizedException


async def soon(what, fits):
    for _ in range(600):
        try:
            if await fits():
                return
        except PrinterOffline:  # until it has answered
            pass
        await asyncio.sleep(0.1)
    sys.exit(f"{what} does not come")


async def refused(call):
    try:
        await call
    except ApiError:
        return
    sys.exit("a call is not refused")


async def expect_no_entry(port, path):
    stranger = OctoprintClient("127.0.0.1", port=port, path=path)
    stranger.set_api_key("wrong-key-of-a-stranger")
    for call in (stranger.get_job_info, stranger.get_printer_info, stranger.get_server_info):
        try:
            await call()
        except UnauthorizedException:
            continue
        sys.exit("a wrong key is taken")
    await stranger._api._session.close()


async def main(port, path, key):
    await expect_no_entry(port, path)
    client = OctoprintClient("127.0.0.1", port=port, path=path)
    client.set_api_key(key)

    server = await client.get_server_info()
    assert server.version and server.safe_mode is None
    assert await client.get_tracking_info() is None
    assert await client.get_discovery_info() is None
    webcam = await client.get_webcam_info()
    assert webcam.enabled is False and webcam.internal_snapshot_url == ""
    await client.connect()
    await refused(client.disconnect())
    await refused(client.shutdown())

    async def is_printing():
        return (await client.get_job_info()).state == "Printing"

    await soon("the print", is_printing)
    job = await client.get_job_info()
    assert job.job.file.name == "moves.gcode" and job.job.file.origin == "local", vars(job)
    assert job.job.file.size > 0 and job.job.estimated_print_time > 0
    assert 0 <= job.progress.completion <= 100 and job.progress.print_time_left >= 0
    printer = await client.get_printer_info()
    flags = printer.state.flags
    assert flags.operational and flags.printing and not flags.paused and not flags.error
    assert {each.name: each.actual_temp for each in printer.temperatures} == {"tool0": 21.5, "bed": 20.25}
    assert printer.has_heated_bed
    await client.set_bed_temperature(60)  # as during a print

    await client.pause_job()
    async def is_paused():
        info = await client.get_printer_info()
        return info.state.flags.paused and (await client.get_job_info()).state == "Paused"

    await soon("the pause", is_paused)
    await client.resume_job()
    await soon("the end of the pause", is_printing)
    await client.cancel_job()

    async def is_free():
        return (await client.get_printer_info()).state.flags.ready

    await soon("the end of the job", is_free)
    assert (await client.get_job_info()).job.file.name is None
    await client.set_bed_temperature(60)
    await client.set_tool_temperature("tool0", 200)
    await client.turn_tool_off("tool0")
    await client.turn_bed_off()
    await refused(client.set_tool_temperature("tool1", 200))
    await refused(client.cancel_job())
    await client._api._session.close()
    print("all calls did what they should")


asyncio.run(main(int(sys.argv[1]), sys.argv[2], sys.argv[3]))
