# SPDX-License-Identifier: Apache-2.0
"""The validation cases: one row each, in the order of the page.

A row names the test in tests/validation (without its ending), what it stands for, and the figure drawn
from its curves (draw.py) with its caption. Everything else is told by the test itself.
"""
import collections

import draw

Case = collections.namedtuple("Case", "stem covers figure caption", defaults=(None, ""))

CASES = [
    Case("02_head_on_collision", "Chung & Ooi 1", draw.head_on,
         "Force against overlap of two spheres: points are the run, lines Hertz's theory."),
    Case("12_plane_impact", "Chung & Ooi 2, 3", draw.restitution,
         "Ratio of speeds against the restitution asked for, aluminium oxide and cast iron at 3.9 m/s."),
    Case("03_oblique_collision", "Chung & Ooi 4, 6, 7", draw.oblique,
         "Aluminium oxide at a rigid wall: the published table (points) and rigid-body theory of sliding (lines)."),
    Case("13_gripping_impact", "Chung & Ooi 5, 6, 8", draw.gripping,
         "Microscopic spheres (left: speed of the surface, middle: spin) and spinning spheres (right). Red: points "
         "that other codes have digitised from the paper's figures, made with other tangential laws."),
    Case("08_rolling_ball", "MFIX-DEM 4, rolling, slope", draw.slip_to_roll,
         "Speed of a sliding ball (full) and of its rim (dashed); the dotted line is 5/7."),
    Case("15_restitution_of_laws", "restitution of all dampings", draw.restitution_of_laws,
         "Ratio of speeds against speed of impact. Left: viscous and tsuji, asked for 0.3, 0.6 and 0.9. Right: "
         "hunt-crossley, which gives the restitution at the speed it is asked for, 0.3 m/s; lines on a linear "
         "spring, points on Hertz's."),
    Case("16_tangential_cycle", "Mindlin and Thornton", draw.cycle,
         "Tangential force against displacement: (a) sliding to and fro, where both are the same; (b) moved, pressed "
         "on, moved back, let off: mindlin gives energy, mindlin-thornton takes it."),
    Case("14_mfix_dem", "MFIX-DEM 1, 2, 3, 5", draw.mfix,
         "DEM01 (left): height of a ball against time, points are the run, the line is theory, k = 2·10⁵ N/m. "
         "DEM02 (right): height of bounces at e = 0.8 for three stiffnesses and for a hard ball."),
    Case("05_elastic_box", "energy balance"),
    Case("17_stack", "energy of a stack", draw.stack,
         "Overlap of each contact of a column of ten balls; the one on the floor is of other materials."),
    Case("09_invariance", "Galileo, rotation, loaded pair"),
    Case("07_joints", "joints of walls"),
    Case("04_lifted_ball", "critical speed"),
    Case("12_convergence", "order of the time integrations"),
    Case("22_mesh_exactness", "meshes against planes"),
    Case("23_shared_corners", "shared corners: the document's Fig 5.20"),
    Case("20_moving_walls", "walls that move"),
    Case("21_wear", "wear of walls"),
    Case("30_clumps", "clumps"),
    Case("10_cooling_gas", "Haff's law", draw.haff,
         "Temperature of the gas (points) and Haff's law without a free parameter (line)."),
    Case("18_silo", "Janssen's law", draw.silo,
         "Force on the floor of a silo against the weight in it."),
    Case("19_heap", "angle of repose, trend", draw.heap,
         "Surface of the heap on its shelf (left) and its slope against rolling friction (right)."),
    Case("01_thesis_bounces", "the document's Figs 4.5, 5.23, 6.0 to 6.6", draw.thesis,
         "The document's experiments: (a) forces at each step of a contact between two balls (Fig 4.5), "
         "(b) overlap against speed with the power 4/5 (Fig 6.0), (c) a dropped ball (Figs 6.1 to 6.3), "
         "(d) speed of a thrown ball and of its rim (Figs 6.4 to 6.6)."),
    Case("06_mill_balance", "energy balance of a mill"),
    Case("11_tiny_mill", "energy balance of a shipped scene"),
]
