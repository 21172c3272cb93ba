# SPDX-License-Identifier: MIT
"""report: the data of its figures, and its errors."""

import csv
import os
import unittest

from command_line import CommandLineTest, share

FILES = {
    "laws": "law,moment_ratio,method,error",
    "curves": "law,c,force,moment,x,y",
    "p_curves": "law,radius_law,mu,load,c,force,moment",
    "c_curves": "law,radius_law,mu,c,load,force,moment",
    "validate": "law,model,parameter,max_error,rms_error,max_over_estimate,max_under_estimate,max_cor_error",
    "ellipse_error": "law,angle,over_estimate,cor_ratio",
    "tables": "law,tolerance,certified_error,nodes,bytes",
    "materials": "material,mu,mu_r,radius,file,law,tolerance,certified_error,nodes,bytes,profile_error",
    "table_error": "law,tolerance,spin_fraction,force_error,moment_error",
    "replay": "trace,boundary,projection,time,state,px,py,angle,depth,load,fx,fy,moment,cor",
    "replay_runs": "trace,law,radius_law,mu,stiffness,twist_stiffness,moment_ratio",
    "replay_limits": "trace,boundary,load,force,moment",
    "pivot": "case,grip,time,x,y,angle,grip_slip,load,friction_force,friction_moment,state,cor,r,rho,trial_r,trial_rho",
    "pivot_materials": "material,case,time,x,y,angle,grip_slip,load,friction_force,friction_moment,state,cor,r,rho,trial_r,trial_rho",
    "pivot_offsets": "material,case,offset,angle,grip_slip,reversals",
    "pivot_stiffness": "case,ratio,angle",
    "pivot_map": "case,offset,rate,angle",
    "fits": "data,model,parameter,value,std_error,unit,note",
    "fit_band": "force,moment,inner_force,inner_moment,outer_force,outer_moment",
    "fit_residuals": "load,force,moment,sigma_force,sigma_moment,residual",
    "translate": "law,radius_law,mu,load,engine,parameter,value,unit,model,max_error,cor_error,loads_error,note,formula,two_bodies",
    "steady_twist": "law,boundary,projection,cor,stiffness_ratio,force,moment,exact_force,exact_moment,error",
}


class Report(CommandLineTest):
    def read(self, name):
        with open(self.directory / "out" / f"{name}.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_the_data_stay_when_drawing_fails(self):
        environment = share(self.directory, "import no_such_module")
        self.assert_fails(1, ["No module named 'no_such_module'", "matplotlib", "out"], "report", "-o", self.directory / "out", env=environment)
        for name, columns in FILES.items():
            rows = self.read(name)
            self.assertEqual(",".join(rows[0]), columns)
            self.assertNotIn(None, {value for row in rows for value in row.values()}, name)
        for row in self.read("materials"):
            self.assertTrue((self.directory / "out" / row["file"]).exists())
        for row in self.read("tables"):
            self.assertLessEqual(float(row["certified_error"]), float(row["tolerance"]))
        for row in self.read("table_error"):
            self.assertLessEqual(max(abs(float(row["force_error"])), abs(float(row["moment_error"]))), float(row["tolerance"]))
        for row in self.read("steady_twist"):
            if (row["boundary"], row["projection"]) == ("table", "closest-point"):
                self.assertLess(float(row["error"]), 1e-7)
        left = {entry.suffix for entry in (self.directory / "out").iterdir()}
        self.assertEqual(left, {".csv"})

    def test_without_its_script(self):
        environment = {**os.environ, "LIMITCURVE_SHARE": str(self.directory)}
        self.assert_fails(1, ["scripts/figures/report.py", "LIMITCURVE_SHARE"], "report", "-o", self.directory / "out", env=environment)

    def test_where_nothing_can_be_written(self):
        self.assert_fails(2, "--output", "report")
        self.assert_fails(1, "/proc/out", "report", "-o", "/proc/out")
        self.assert_fails(1, "taken", "report", "-o", self.file("taken", ""))


if __name__ == "__main__":
    unittest.main()
