#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The shipped tiny mill, shortened: power, its parts and the solidity of the charge from its recordings.

Setup      scenes/tiny-mill.yaml, a slice of 8 mm instead of 20 mm, 0.9 turns instead of 2, fields and
           power over the last 0.5 turns, which are four passages of lifters.
Formula    Mean torque times speed = (losses + Mindlin residue + change of stored energy) / time
           = rise of the work in series.csv / time = sum over the parts of the wall. 0.5 to 0.62 of a
           bed is solid.
Source     Conservation of energy; Scott & Kilgour (1969), J. Phys. D 2, 863.
Tolerance  1 % of the power, and of the balance of the whole run; 0.5 % for the work, which the series
           has once a millisecond; rounding for the sum.
"""
import json
import math
import os

import common_runs as lab

SHORT = [("length: 20 mm", "length: 8 mm"), ("end: 2 rev", "end: 0.9 rev"),
         ("start: 1 rev, duration: 1 rev", "start: 0.4 rev, duration: 0.5 rev"),
         ("frames: 10 ms", "frames: none, pictures: no")]
BEGIN, END = 0.4 * 2 * math.pi, 0.9 * 2 * math.pi  # rad   angles of the drum


def work_at(rows, angle):
    """Work of the drum up to an angle, between two rows of the series."""
    for a, b in zip(rows, rows[1:]):
        if a["drum_angle_rad"] <= angle <= b["drum_angle_rad"] + 1e-9:
            share = (angle - a["drum_angle_rad"]) / (b["drum_angle_rad"] - a["drum_angle_rad"])
            return a["work_j"] + share * (b["work_j"] - a["work_j"])
    raise AssertionError(f"series.csv does not reach {angle} rad")


def a_shortened_tiny_mill_balances():
    folder = lab.run("tiny-mill", SHORT)
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        s = json.load(file)
    rows = lab.rows(folder, "series.csv")
    power = s["power_torque_w"]
    told = s["power_dissipated_w"] + s["power_stored_w"]
    worked = (work_at(rows, END) - work_at(rows, BEGIN)) / s["power_window_s"]
    text = (f"torque {power:.5g} W, told {told:.5g} W, worked {worked:.5g} W, residual "
            f"{s['energy_residual_relative']:.2g}, solidity {s['solidity_bulk']}")
    print("  " + text)
    assert s["power_passages"] == 4, text
    assert power > 0.01, text
    lab.measure("losses and stored energy, by torque times speed", "half a turn", told / power, 1, 0.01)
    lab.measure("rise of the work, by torque times speed", "half a turn", worked / power, 1, 0.005)
    assert abs(sum(s["power_parts_w"].values()) / power - 1) < 1e-12, s["power_parts_w"]
    lab.measure("residual of the energy balance", "whole run", s["energy_residual_relative"], 0, 0.01)
    lab.measure("solidity of the bed", "half a turn", s["solidity_bulk"], 0.56, 0.06)


lab.main([a_shortened_tiny_mill_balances])
