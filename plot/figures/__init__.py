# SPDX-License-Identifier: Apache-2.0
"""The figures of a run, in the order they are drawn; a new figure is a new row here."""


def figure_list():
    """Pairs of a name and a function draw(run, gallery) that raises NotRecorded if it can't."""
    from figures import energy, maps, particles, paths, power, quivers, ring, traces
    return (
        ("porosity maps", maps.porosity),
        ("velocity quivers", quivers.velocity),
        ("component maps", maps.components),
        ("particles", particles.cross_section),
        ("power", power.power),
        ("energy", energy.energy),
        ("charge around the shell", ring.ring),
        ("paths", paths.paths),
        ("traces", traces.motion),
        ("contact forces", traces.contacts),
    )
