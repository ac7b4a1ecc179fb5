#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints a G-code file with Cura's own USB device and writes what it noticed as JSON.

The device is the file of the installed Cura, unchanged. What it imports of the rest of Cura (windows,
settings, the base class of devices) are stand-ins: they decide nothing that goes over the line.
Exit status 0 where the whole file was sent and acknowledged, 1 otherwise.
"""
import argparse
import importlib
import json
import sys
import time
import types
from unittest.mock import MagicMock

STAND_INS = [
    "UM", "UM.i18n", "UM.Job", "UM.Logger", "UM.Mesh", "UM.Mesh.MeshWriter", "UM.Message", "UM.PluginRegistry",
    "UM.Qt", "UM.Qt.Duration", "cura", "cura.CuraApplication", "cura.PrinterOutput",
    "cura.PrinterOutput.FirmwareUpdater", "cura.PrinterOutput.GenericOutputController",
    "cura.PrinterOutput.Models", "cura.PrinterOutput.Models.PrinterOutputModel",
    "cura.PrinterOutput.Models.PrintJobOutputModel", "cura.PrinterOutput.PrinterOutputDevice",
]


class Connection:
    Closed, Connected, Error = "closed", "connected", "error"


class OutputDevice:
    """What the device takes from its base class."""

    def __init__(self, device_id, connection_type=None):
        self._connection_state = Connection.Closed
        self._printers = []
        self._firmware_name = None
        self.writeStarted = self.writeFinished = MagicMock()

    def setConnectionState(self, state):
        self._connection_state = state

    def close(self):
        self.setConnectionState(Connection.Closed)

    def __getattr__(self, name):
        if name.startswith("set"):
            return lambda *values: None
        raise AttributeError(name)


def device_class(plugin):
    for name in STAND_INS:
        sys.modules[name] = MagicMock()
    base = sys.modules["cura.PrinterOutput.PrinterOutputDevice"]
    base.PrinterOutputDevice, base.ConnectionState = OutputDevice, Connection
    sys.modules["UM.Job"].Job = object
    sys.modules["cura.PrinterOutput.FirmwareUpdater"].FirmwareUpdater = object
    sys.modules["UM.PluginRegistry"].PluginRegistry.getInstance().getPluginPath.return_value = plugin
    application = sys.modules["cura.CuraApplication"].CuraApplication.getInstance()
    application.getPrintInformation().currentPrintTime.getDisplayString.return_value = "60"
    # Not the package's own first file, which makes windows; the part that programs boards is not needed.
    package = types.ModuleType("USBPrinting")
    package.__path__ = [plugin]
    sys.modules["USBPrinting"] = package
    sys.modules["USBPrinting.AvrFirmwareUpdater"] = MagicMock()
    sys.modules["USBPrinting.AutoDetectBaudJob"] = MagicMock()
    return importlib.import_module("USBPrinting.USBPrinterOutputDevice").USBPrinterOutputDevice


class Overheard:
    """The device's serial port, and what came from it."""

    def __init__(self, port):
        self.port = port
        self.lines = []

    def readline(self):
        line = self.port.readline()
        self.lines.append(line)
        return line

    def __getattr__(self, name):
        return getattr(self.port, name)


def wait_for(condition, seconds):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.1)
    return condition()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file")
    parser.add_argument("port")
    parser.add_argument("--plugin", required=True, help="Cura's folder plugins/USBPrinting")
    parser.add_argument("--baud", type=int, default=250000)
    parser.add_argument("--timeout", type=float, default=900, help="for the print, in seconds")
    parser.add_argument("--summary", required=True)
    arguments = parser.parse_args()

    device = device_class(arguments.plugin)(arguments.port, arguments.baud)
    device.connect()
    heard = device._serial = Overheard(device._serial)
    online = wait_for(lambda: device.getFirmwareName() is not None, 60)
    ended = made = False
    if online:
        with open(arguments.file, encoding="ascii") as file:
            device._printGCode(file.read())
        ended = wait_for(lambda: not device._is_printing, arguments.timeout)
        device.sendCommand("M400")
        # Without a number: a bad line may damage it or what it says.
        end = time.monotonic() + 300
        while not made and time.monotonic() < end:
            device.sendCommand("M118 all moves are made")
            made = wait_for(lambda: b"all moves are made\n" in heard.lines, 10)
    name = device.getFirmwareName()
    device.close()
    with open(arguments.summary, "w", encoding="ascii") as file:
        json.dump({"online": online, "firmware_name": name, "ended": ended, "made": made,
                   "lines": device._gcode_position}, file, indent=1)
    return 0 if ended and made else 1


sys.exit(main())
