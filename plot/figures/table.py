# SPDX-License-Identifier: Apache-2.0
"""CSV files of a run as columns."""
import csv
import os

import numpy as np


class NotRecorded(Exception):
    """What a figure needs was not recorded."""


def read_table(path):
    """A CSV file as a dict of columns: numbers where all are numbers, else strings. A last line
    that was cut off while being written is left out."""
    name = os.path.basename(path)
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    except OSError:
        raise NotRecorded(f"no {name}") from None
    if len(rows) < 2:
        raise NotRecorded(f"{name} holds no row yet")
    head = [title.strip() for title in rows[0]]
    rows = [row for row in rows[1:] if len(row) == len(head)]
    if not rows:
        raise NotRecorded(f"{name} holds no whole row yet")
    table = {}
    for title, column in zip(head, zip(*rows)):
        try:
            table[title] = np.array([float(text) if text else np.nan for text in column])
        except ValueError:
            table[title] = np.array(column)
    return table
