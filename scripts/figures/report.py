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
pivot.csv           case,grip,time,x,y,angle,grip_slip,load,friction_force,friction_moment,state,cor,r,rho,trial_r,trial_rho
                      as `pivot`, every tenth step, for sandpaper and the block's default size; grip is release or operator
                      (target=30deg)
pivot_offsets.csv   material,case,offset,angle,grip_slip,reversals
                      what an operator achieves over the offset [m]: angle [rad], slip [m], how often it turned back by 0.1 degrees
pivot_map.csv       case,offset,rate,angle
                      angle at which the block leaves a grip that eases at a steady rate [N/s], for a grid of offsets and rates
pivot_materials.csv material,case and the columns of `pivot`: each material's block, its grip left open
pivot_stiffness.csv case,ratio,angle
                      by how much the block turns before it leaves the fingers, over k_r/(k_l (mu_r/mu)^2)
table_1.csv         data/materials.csv, as it was shipped
pinch.csv           friction and the columns of `replay`: two fingers (soft, point) on pinch_trace.csv, data/scenes/pinch.csv
fits.csv            data,model,parameter,value,std_error,unit,note
                      as `fit` on the measurements in data/fit
fit_band.csv        force,moment,inner_force,inner_moment,outer_force,outer_moment
                      the curve fitted to data/fit/slips.csv, per newton of load, and its 95 % band
fit_residuals.csv   load,force,moment,sigma_force,sigma_moment,residual
                      its samples, and their distances from the curve in standard deviations
patch_pushes.csv    data,share,exact,ellipsoid
                      the measured pushes of data/measured: share of rotation, power over that of the patch and of the ellipsoid
patch_fits.csv      data,parameter,value,std_error,unit
                      as `fit friction` of those
patch_errors.csv    shape,aspect,law,model,parameter,max_error,rms_error,max_over_estimate,max_under_estimate,max_cor_error
                      as `validate --patch` for elliptic Hertz contacts and rectangles
engine_drag.csv     engine,version,model,c,force,moment,exact_force,exact_moment
                      data/engines/drag.csv: a finger dragged in the engines themselves about centres of rotation c [a]; force and
                      moment over their limits, and those of the law
translate.csv       law,radius_law,mu,load,engine,parameter,value,unit,model,max_error,cor_error,
                      loads_error,note,formula,two_bodies
                      as `translate`
work_precision_*.csv  what scripts/maintain/work_precision measured (data/README.md), as it was shipped
"""

import argparse
import html
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import curve_figures  # noqa: E402
import experiment_figures  # noqa: E402
import finger_figures  # noqa: E402
import patch_figures  # noqa: E402
import pictures  # noqa: E402
import touch_charts  # noqa: E402
from chart_style import Table, save, short, write_whole  # noqa: E402
from report_page import Used, page  # noqa: E402
from work_precision_figures import work_precision  # noqa: E402

FILES = ("laws", "curves", "p_curves", "c_curves", "validate", "ellipse_error", "tables", "materials", "table_error", "replay",
         "replay_runs", "replay_limits", "steady_twist", "pivot", "pivot_map", "pivot_materials", "pivot_offsets", "pivot_stiffness", "table_1", "pinch", "pinch_trace", "fits", "fit_band", "fit_residuals", "patch_pushes",
         "patch_fits", "patch_errors", "engine_drag",
         "translate", "work_precision_wrench", "work_precision_step", "work_precision_scaling")

FIGURES = {
    "what_is_computed": pictures.what_is_computed,
    "limit_curves": curve_figures.limit_curves,
    "load_curves": curve_figures.load_curves,
    "ellipse_error": curve_figures.ellipse_error,
    "models": curve_figures.models,
    "tables": curve_figures.tables,
    "god_object": finger_figures.god_object,
    "repositioning": finger_figures.repositioning,
    "felt": finger_figures.felt,
    "steady_twist": finger_figures.steady_twist,
    "pivot": experiment_figures.pivot,
    "pivot_operator": experiment_figures.pivot_operator,
    "pivot_offsets": experiment_figures.pivot_offsets,
    "pivot_stiffness": experiment_figures.pivot_stiffness,
    "pivot_map": finger_figures.pivot_map,
    "table_1": experiment_figures.table_1,
    "pinch": experiment_figures.pinch,
    "fits": curve_figures.fits,
    "patches": patch_figures.patches,
    "engines": curve_figures.engines,
    "work_precision": work_precision,
}


def percent(fraction, digits=2):
    return f"{100 * fraction:.{digits}f} %"


def numbers_to_remember(data):
    """The three figures a reader should take away, each with the sentence that explains it."""
    ellipses = data["validate"].where(model="ellipse")
    worst, best = (pick(ellipses, key=lambda row: row["max_over_estimate"]) for pick in (max, min))
    twist = data["steady_twist"]
    radial, closest = (twist.where(boundary="table", projection=name) for name in ("radial", "closest-point"))
    ratios = twist.column("stiffness_ratio")
    usual = data["tables"].where(law="hertz", tolerance=min(data["tables"].column("tolerance"), key=lambda value: abs(value - 1e-8) / value))[0]
    look_up = data["work_precision_wrench"].where(law="hertz", family="table", parameter=1e-8)[0]
    step = data["work_precision_step"].where(boundary="table 1e-8", projection="closest-point")[0]
    return [
        (percent(worst["max_over_estimate"], 1),
         f"by which the usual ellipse over-estimates what a contact bears, at worst ({worst['law']}; {percent(best['max_over_estimate'], 1)} for "
         f"{best['law']}). Its centre of rotation is farther off."),
        (percent(max(radial.column("error")), 0),
         f"error of the friction of a steady twist with the radial projection, for stiffness ratios κ from {min(ratios):.2g} to {max(ratios):.2g}; "
         f"{max(closest.column('error')):.0e} with the closest point."),
        (f"{look_up['mean_ns']:.0f} ns",
         f"for a look-up in a table that is certified to {usual['certified_error']:.1e} ({usual['bytes']:.0f} bytes), and {step['many_warm_ns']:.0f} ns for a "
         "step of a finger on it: a finer table costs almost no time."),
    ]


def facts_table(columns, rows):
    """An HTML table; columns of numbers (that begin with a digit in every row) stand to the right, of words to the left."""
    numeric = [all(cell[:1].isdigit() for cell in column) for column in zip(*rows)]

    def line(tag, cells):
        marked = zip(numeric, cells)
        return "<tr>" + "".join(f"<{tag}{' class=number' if number else ''}>{cell}</{tag}>" for number, cell in marked) + "</tr>"

    head, body = line("th", columns), "".join(line("td", row) for row in rows)
    return f'<table><thead>{head}</thead><tbody>{body}</tbody></table>'


def materials_table(data):
    def link(name):
        return f'<a href="{html.escape(name)}">{html.escape(name)}</a>'

    return facts_table(
        ("material", "μ", "μ<sub>r</sub> [mm]", "law", "radius a [mm]", "certified error", "nodes", "bytes", "file"),
        [(row["material"], f"{row['mu']:g}", f"{1e3 * row['mu_r']:g}", row["law"], f"{1e3 * row['radius']:.2f}",
          f"{row['certified_error']:.1e}", f"{row['nodes']:.0f}", f"{row['bytes']:.0f}", link(row["file"])) for row in data["materials"]])


def laws_table(data):
    rows = []
    for law in data["laws"]:
        ellipse = data["validate"].where(law=law["law"], model="ellipse")[0]
        cor = data["ellipse_error"].where(law=law["law"])
        ratios = [row["cor_ratio"] for row in cor if row["cor_ratio"] == row["cor_ratio"]]
        rows.append((law["law"], f"{law['moment_ratio']:.4g}", percent(ellipse["max_over_estimate"]), f"{min(ratios):.2f} … {max(ratios):.2f}"))
    return facts_table(("law", "moment ratio m<sub>0</sub>", "ellipse too strong by", "centre of rotation, ellipse / true"), rows)


def unit_of(row):
    """A bare 1 for what has none would be read as a number."""
    return "–" if row["unit"] == 1 else html.escape(str(row["unit"])).replace("^gamma", "<sup>γ</sup>")


def engines_table(data):
    first = data["translate"][0]
    rows = [(html.escape(row["engine"]), html.escape(row["parameter"]), f"{row['value']:.6g}" if isinstance(row["value"], float) else row["value"], unit_of(row),
             html.escape(row["model"]), percent(row["max_error"], 1)) for row in data["translate"].where(law=first["law"])]
    return facts_table(("engine", "parameter", "value", "unit", "its limit curve", "error that remains"), rows)


def error_of(row):
    """Degrees of freedom and probabilities have none."""
    return f"{row['std_error']:.2g}" if row["std_error"] else "–"


def fits_table(data):
    return facts_table(("data", "fit", "parameter", "value", "standard error", "unit"),
                       [(row["data"], row["model"], html.escape(row["parameter"]), f"{row['value']:.5g}", error_of(row),
                         unit_of(row)) for row in data["fits"]])


def patch_fits_table(data):
    return facts_table(("data", "parameter", "value", "standard error", "unit"),
                       [(row["data"], row["parameter"].replace("_", " "), f"{row['value']:.4g}", f"{row['std_error']:.2g}", unit_of(row))
                        for row in data["patch_fits"]])


def sections(data):
    """The page's story: heading, figures, each with what to see in it and what to do, and a table; each number is read from the files."""
    ellipses = data["validate"].where(model="ellipse")
    over = sorted(ellipses.column("max_over_estimate"))
    fitted, boxes = (sorted(data["validate"].where(model=name).column("max_error")) for name in ("ellipse-least-squares", "box"))
    ratios = [row["cor_ratio"] for row in data["ellipse_error"] if row["cor_ratio"] == row["cor_ratio"]]
    run, twist = data["replay_runs"][-1], data["steady_twist"][0]
    engine = data["translate"][0]
    certified = max(data["table_error"].column("tolerance"))
    drifts = [" and ".join(f"{row['value']:.2f} ± {row['std_error']:.2f}" for row in data["patch_fits"].where(parameter=name))
              for name in ("drift", "drift_ellipsoid")]
    square, long = ([row for row in data["patch_errors"].where(shape="rectangle", aspect=aspect) if row["model"].startswith("disc:")][0]
                    for aspect in (1, 5))
    return [
        pictures.section(),
        ("One curve for each pressure law", [
            ("limit_curves", "A pressure law says how the load spreads over the contact. Divided by its own limits the curve of every law lies <em>inside</em> the dashed ellipse; laws "
             "differ little in shape, and much in the moment they bear.",
             "not sure which law? hertz, with the friction moment that you measured."),
        ], laws_table(data)),
        ("Loads and centres of rotation", [
            ("load_curves", "p-curves (blue): limit curves of fixed loads. c-curves (orange): force and moment at fixed centres of rotation, straight lines only if the contact does not "
             "grow with the load.", "give the finger its a(P); do not scale one curve along straight lines."),
        ], ""),
        ("How wrong the ellipse is", [
            ("ellipse_error", f"Left: it is too strong by {percent(over[0], 1)} to {percent(over[-1], 1)}. Right: its centre of rotation is {min(ratios):.2f} to "
             f"{max(ratios):.2f} times as far away as the true one.", "an ellipse for rough forces, not for the motion after slip."),
            ("models", f"The best fitted ellipse is still off by {percent(fitted[0], 1)} to {percent(fitted[-1], 1)}. Limits of force and moment that know "
             f"nothing of each other, a box, are too strong by up to {percent(boxes[-1], 0)}.", "a table: it is as fast, and its error certified."),
        ], ""),
        ("Look-up tables", [
            ("tables", f"Left: bytes against tolerance. Right: the error of a table of {short(certified)} between its nodes, inside the tolerance (grey).",
             "a tolerance of 1e-8, and stop thinking about the curve."),
        ], "<p>Tables for Table 1 of the paper. The radius follows from the measured ratio μ<sub>r</sub>/μ and the law, and exceeds a fingertip’s: keep μ<sub>r</sub> itself "
           "where it was measured.</p>" + materials_table(data)),
        ("A god-object that obeys the curve", [
            ("god_object", "A god-object (proxy) is where the finger would be if it could not enter; springs pull it to its goal, by r, and turn it, by ρ. Its offset on three scripted "
             "motions, with the limit curves of several loads: a drag stays on the axis of r, a twist on that of ρ; in the third the finger slides and turns while the load changes.",
             "look at combined motions: only there do models differ."),
            ("repositioning", "Single steps of that slip. The goal moves on and leaves the proxy outside the curve of the present load (diamonds); it is moved back on to it (dots), along the "
             "ray to the origin or to the closest point.", "the closest point, the default."),
            ("felt", f"What the finger feels. Shaded: slip, by the exact curve (law {html.escape(run['law'])}, μ = {run['mu']:g}, k<sub>l</sub> = {run['stiffness']:g} N/m, "
             f"k<sub>r</sub> = {run['twist_stiffness']:g} N m/rad).", "a table and the closest point where a finger slides and turns at once."),
        ], ""),
        ("The projection matters more than the curve", [
            ("steady_twist", f"A finger turns steadily about a centre at c = {twist['cor']:g} a. The closest point gives the wrench of eq. (17) at every stiffness; the radial projection one "
             "that the ratio of the springs sets, whatever the curve. On the ellipse the closest point has the ellipse’s own error.",
             "the radial projection only if k<sub>r</sub> is near k<sub>l</sub>(μ<sub>r</sub>/μ)²."),
        ], ""),
        experiment_figures.section(data),
        ("From measurements to parameters", [
            ("fits", "A synthetic sensor log with gross outliers and the limit curve fitted to it by a robust loss; the 95 % band is hardly wider than the line (lens). "
             "Grey on the right: where 95 % of the residuals of a right model lie.", "<code>--loss cauchy</code> if some rows may not be slips."),
        ], fits_table(data)),
        ("Contacts that are not round", [
            ("patches", "Left: a plate on three known points, pushed by others over hardboard and plywood. Measured power over the power of the model must be one friction coefficient at any "
             f"share of rotation; its drift is {drifts[0]} for three points (blue), {drifts[1]} for the usual ellipsoid (orange). Nothing is fitted. Right: the best disc is off by "
             f"{percent(square['max_error'], 1)} for a square and {percent(long['max_error'], 0)} for a rectangle 5 : 1.",
             "the patch itself, or ask <code>limitcurve choose --patch</code>."),
        ], patch_fits_table(data)),
        ("Speed against accuracy", [
            ("work_precision", "One dot for every way to a friction wrench, on one machine.",
             "a table of 1e-8 in a loop, <code>evaluate</code> for a reference."),
        ], ""),
        ("The same finger in a physics engine", [
            ("engines", "A finger dragged in the engines themselves. MuJoCo’s elliptic cone is the ellipse, its default pyramid the diamond; ODE and Bullet limit force and moment each on its "
             "own, so that nearly all their wrenches lie in the box’s corner. The limits of pure force and moment are right, in the pyramid for slips of 30 mm/s and more.",
             "MuJoCo’s elliptic cone, if you can choose."),
        ],
         f"<p>What to type for a finger of the {html.escape(engine['law'])} law, a(P) by {html.escape(engine['radius_law'])}, μ = {engine['mu']:g}, at {engine['load']:g} N. Formulas and rules "
         "for two bodies: <code>limitcurve translate</code>.</p>" + engines_table(data)),
    ]


def main():
    parser = argparse.ArgumentParser(description="Draws the report from the CSVs that `limitcurve report` writes.")
    parser.add_argument("--data", required=True, type=Path, help="folder of the CSV files")
    parser.add_argument("--output", required=True, type=Path, help="folder for index.html and the figures")
    arguments = parser.parse_args()
    try:
        data = {name: Table.read(arguments.data / f"{name}.csv") for name in FILES}
        arguments.output.mkdir(parents=True, exist_ok=True)
        pictures = {}
        for number, (name, draw) in enumerate(FIGURES.items(), 1):
            used = Used(data)
            pictures[name] = save(draw(used), arguments.output, name), used.names
            print(f"figure {number} of {len(FIGURES)}", flush=True)  # `limitcurve report` makes progress of it
        touch = {"limit_curves": touch_charts.limit_curves(data),
                 "load_curves": touch_charts.load_curves(data)}
        text = page(data, numbers_to_remember(data), sections(data), pictures, touch)
        write_whole(arguments.output / "index.html", text.encode("utf-8"))
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"report.py: error: {type(error).__name__}: {error}")

    print(f"{arguments.output}/index.html  the report: {len(pictures)} figures, each beside it as SVG and PNG")
    print(f"{arguments.output}/*.csv       the data it is drawn from, and {len(data['materials'])} look-up tables: "
          f"{', '.join(data['materials'].column('file'))}")
    print("To remember:")
    for number, (value, words) in enumerate(numbers_to_remember(data), 1):
        print(f"  {number}. {value} {words}")


if __name__ == "__main__":
    main()
