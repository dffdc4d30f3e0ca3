#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The shipped tiny mill, shortened: power, solidity and the speed of the charge from its recordings.

Setup      scenes/tiny-mill.yaml, a slice of 8 mm instead of 20 mm, 0.9 turns instead of 2, fields and
           power over the second half.
Formula    Mean torque times speed = (losses + Mindlin residue + change of stored energy) / time, over
           the same passages of lifters. 0.5 to 0.62 of a bed is solid.
Source     Conservation of energy; Scott & Kilgour (1969), J. Phys. D 2, 863.
Tolerance  1 % of the power, and of the balance of the whole run.
"""
import json
import os

import common_runs as lab

SHORT = [("length: 20 mm", "length: 8 mm"), ("end: 2 rev", "end: 0.9 rev"),
         ("start: 1 rev, duration: 1 rev", "start: 0.4 rev, duration: 0.5 rev"),
         ("frames: 10 ms", "frames: none, pictures: no")]


def a_shortened_tiny_mill_balances():
    folder = lab.run("tiny-mill", SHORT)
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        s = json.load(file)
    told = s["power_dissipated_w"] + s["power_stored_w"]
    text = (f"torque {s['power_torque_w']:.5g} W, told {told:.5g} W, residual "
            f"{s['energy_residual_relative']:.2g}, solidity {s['solidity_bulk']:.3f}")
    print("  " + text)
    assert s["power_torque_w"] > 0.01, text
    assert abs(told / s["power_torque_w"] - 1) < 0.01, text
    assert abs(s["energy_residual_relative"]) < 0.01, text
    assert 0.5 < s["solidity_bulk"] < 0.62, text


lab.main([a_shortened_tiny_mill_balances])
