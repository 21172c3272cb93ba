# SPDX-License-Identifier: MIT
"""The finger of the replay tests, the shortest trace in which it is free, sticks and slips, and the output of replay
for it."""

import math

COLUMNS = "time,state,px,py,angle,depth,load,fx,fy,moment,cor"
M0 = 3 * math.pi / 16  # Hertz
FINGER = [
    "--law", "hertz", "--radius-law", "constant:a=0.006", "--mu", "0.6", "--stiffness", "1000", "--twist-stiffness",
    "0.036"
]
MEASURED = [word for word in FINGER
            if word not in ("--radius-law", "constant:a=0.006")]  # without radius law, for --mu-r
TRACE = "time,x,y,z,twist\n0,0,0,0.001,0\n0.001,0,0,-0.001,0\n0.002,0.0001,0,-0.001,0\n0.003,0.005,0,-0.001,0\n"
