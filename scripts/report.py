#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the report: figures (SVG and PNG) and one self-contained page from the CSVs that `limitcurve report` writes.

    report.py --data DIR --output DIR

It only draws; every number comes from these files in DIR, long format, one header line, numbers in the units of the
subcommands (SI, or unit wrenches):

laws.csv            law,moment_ratio,method,error
                      as `limitcurve laws`; its order is the order of colours
curves.csv          law,c,force,moment,x,y
                      as `curve` for every law of laws.csv, evenly in slip angle, >= 181 points
p_curves.csv        law,radius_law,mu,load,c,force,moment
                      as `p-curves`, law hertz, for one constant and one load-dependent radius law (both with the same
                      radius at the middle load), 5 loads or so
c_curves.csv        law,radius_law,mu,c,load,force,moment
                      as `c-curves`, same laws and loads' range (finely, from 0), 5 CORs or so incl. 0 and inf
validate.csv        law,model,parameter,max_error,rms_error,max_over_estimate,max_under_estimate,max_cor_error
                      as `validate` for every law
ellipse_error.csv   law,angle,over_estimate,cor_ratio
                      for every law over the direction `angle` = atan2(y, x) [rad] in [0, pi/2] of the wrench in the
                      normalised plane: over_estimate = radius of the ellipse through the intercepts over that of the
                      exact curve, minus 1; cor_ratio = COR that the ellipse implies over the true one (ends: the limit,
                      or nan)
tables.csv          law,tolerance,certified_error,nodes,bytes
                      as `table` for every law of laws.csv that the demo has time for, tolerances 1e-2 ... 1e-10
materials.csv       material,mu,mu_r,law,radius,tolerance,certified_error,nodes,bytes,file
                      Table 1 (data/materials.csv): for each material and the laws hertz and uniform the contact radius
                      that its ratio implies (mu_r/mu/m0) [m], and the table written for it (file: name in DIR)
table_error.csv     law,tolerance,spin_fraction,force_error,moment_error
                      table minus exact, signed, at points between the nodes, for laws hertz and uniform (at least) at
                      tolerance 1e-8, >= 500 points over u in [0, 1]
replay.csv          trace,boundary,projection,time,state,px,py,angle,depth,load,fx,fy,moment,cor
                      as `replay` of the three traces press_drag_release, press_twist_release, slide_twist_load,
                      each with ellipse/radial and table/closest-point
replay_runs.csv     trace,law,radius_law,mu,stiffness,twist_stiffness,moment_ratio
                      the parameters those runs share; moment_ratio = m0 of the law
replay_limits.csv   trace,boundary,load,force,moment
                      the p-curve [N, N m] of each boundary (ellipse, table) at 5 loads or so, the largest of the run
                      among them
steady_twist.csv    law,boundary,projection,cor,stiffness_ratio,force,moment,exact_force,exact_moment,error
                      the wrench at which a finger driven at a constant twist with COR c = cor*a settles (unit wrenches),
                      against kappa = k_r/k_l/(m0 a)^2 from 0.1 to 10, finely in log; for table/closest-point,
                      table/radial, ellipse/closest-point, ellipse/radial; error = norm of the difference of (f, m/m0)
"""
