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
validate_peaked.csv the same for a law heaped at the centre, which the ellipse under-estimates
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
         "replay_runs", "replay_limits", "steady_twist", "pivot", "pivot_map", "pivot_materials", "pivot_offsets", "pivot_stiffness", "table_1", "pinch", "pinch_trace", "validate_peaked", "fits", "fit_band", "fit_residuals", "patch_pushes",
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


def under_estimates(data):
    """Whether an ellipse ever under-estimates, in a sentence."""
    known = max(data["validate"].where(model="ellipse"), key=lambda row: row["max_under_estimate"])
    peaked = data["validate_peaked"].where(model="ellipse")[0]
    first = "It under-estimates none of these laws" if known["max_under_estimate"] < 1e-6 else (
        f"It under-estimates {known['law']} by {percent(known['max_under_estimate'])}")
    return f"{first}; a pressure heaped at the centre ({peaked['law']}) by up to {percent(peaked['max_under_estimate'], 1)}."


def numbers_to_remember(data):
    """The three figures a reader should take away, each with the sentence that explains it."""
    ellipses = data["validate"].where(model="ellipse")
    worst, best = (pick(ellipses, key=lambda row: row["max_over_estimate"]) for pick in (max, min))
    twist = data["steady_twist"]
    radial = twist.where(boundary="table", projection="radial")
    closest = twist.where(boundary="table", projection="closest-point")
    ratios = twist.column("stiffness_ratio")
    at_one = min(radial, key=lambda row: abs(row["stiffness_ratio"] - 1))["error"]
    fine = data["tables"].where(tolerance=min(data["tables"].column("tolerance"), key=lambda value: abs(value - 1e-8) / value))
    usual, large = fine[0], max(fine, key=lambda row: row["bytes"])
    return [
        (percent(worst["max_over_estimate"]),
         f"by which the ellipse over-estimates what a contact bears, at worst ({worst['law']}; {percent(best['max_over_estimate'])} for "
         f"{best['law']}). {under_estimates(data)}"),
        (percent(max(radial.column("error")), 0),
         f"error of the steady wrench when a finger driven at a constant twist is projected radially, for stiffness ratios κ from "
         f"{min(ratios):.2g} to {max(ratios):.2g} ({percent(at_one, 1)} at κ = 1). On the closest point it is "
         f"{max(closest.column('error')):.0e}."),
        (f"{usual['bytes']:.0f} bytes",
         f"hold a look-up table of the {usual['law']} law that is certified to {usual['certified_error']:.1e} in force and moment. "
         f"No law here needs more than {large['bytes']:.0f} bytes ({large['law']})."),
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
        rows.append((law["law"], f"{law['moment_ratio']:.12g}", law["method"], percent(ellipse["max_over_estimate"]),
                     f"{min(ratios):.2f} … {max(ratios):.2f}"))
    return facts_table(("law", "moment ratio m<sub>0</sub>", "evaluated by", "ellipse too strong by", "COR, ellipse / true"), rows)


def readable(cell):
    return f"{cell:.6g}" if isinstance(cell, float) else cell


def unit_of(row):
    """A bare 1 for what has none would be read as a number."""
    return "–" if row["unit"] == 1 else html.escape(str(row["unit"])).replace("^gamma", "<sup>γ</sup>")


def engines_table(data):
    first = data["translate"][0]
    rows = [(html.escape(row["engine"]), html.escape(row["parameter"]), readable(row["value"]), unit_of(row), html.escape(str(readable(row["formula"]))),
             html.escape(row["two_bodies"]), html.escape(row["note"]), html.escape(row["model"]),
             percent(row["max_error"], 1)) for row in data["translate"].where(law=first["law"])]
    return facts_table(("engine", "parameter", "value", "unit", "formula", "of two bodies", "note", "its limit curve", "error that remains"), rows)


def fits_table(data):
    return facts_table(("data", "fit", "parameter", "value", "standard error", "unit"),
                       [(row["data"], row["model"], html.escape(row["parameter"]), f"{row['value']:.5g}",
                         "–" if row["std_error"] == "" else f"{row['std_error']:.2g}", unit_of(row)) for row in data["fits"]])


def patch_fits_table(data):
    return facts_table(("data", "parameter", "value", "standard error", "unit"),
                       [(row["data"], row["parameter"].replace("_", " "), f"{row['value']:.4g}", f"{row['std_error']:.2g}", unit_of(row))
                        for row in data["patch_fits"]])


def sections(data):
    """The page's story: heading, figure, what to see in it; each number is read from the files."""
    ellipses = data["validate"].where(model="ellipse")
    over = sorted(ellipses.column("max_over_estimate"))
    quartics, superellipses, boxes, fitted = (sorted(data["validate"].where(model=name).column("max_error"))
                                              for name in ("quartic", "superellipse", "box", "ellipse-least-squares"))
    ratios = [row["cor_ratio"] for row in data["ellipse_error"] if row["cor_ratio"] == row["cor_ratio"]]
    run, twist = data["replay_runs"][-1], data["steady_twist"][0]
    engine = data["translate"][0]
    certified = max(data["table_error"].column("tolerance"))
    drifts = [" and ".join(f"{row['value']:.3f} ± {row['std_error']:.3f}" for row in data["patch_fits"].where(parameter=name))
              for name in ("drift", "drift_ellipsoid")]
    square, long = ([row for row in data["patch_errors"].where(shape="rectangle", aspect=aspect) if row["model"].startswith("disc:")][0]
                    for aspect in (1, 5))
    worst_between = max(max(abs(row["force_error"]), abs(row["moment_error"])) for row in data["table_error"])
    return [
        pictures.section(),
        ("One curve for each pressure law", [
            ("limit_curves", "The limit curves by eq. (17) of Frisoli et al. (2006), in units of μP and μPa, and each divided by its own limits (the paper’s "
             "Fig. 3). There every law lies <em>inside</em> the dashed ellipse: a contact holds less than the "
             "unit circle says. The laws differ little in shape and much in the moment they bear."),
        ], laws_table(data)),
        ("Loads and centres of rotation", [
            ("load_curves", "p-curves (blue, load fixed) and c-curves (orange, centre of rotation fixed) of the Hertz law, the paper’s "
             "Fig. 4. With a contact radius that does not depend on the load, c-curves are straight lines from the origin. With one that "
             "grows with the load they bend, and the paper’s construction along straight lines no longer keeps the centre of rotation."),
        ], ""),
        ("How wrong the ellipse is", [
            ("ellipse_error", f"Left: the capacity is over-estimated by {percent(over[0])} to {percent(over[-1])}, depending on the law, about half "
             "way between pure force and pure moment. Right: the centre of rotation that follows from the ellipse’s normal is "
             f"{min(ratios):.2f} to {max(ratios):.2f} times as far away as the true one. This is what the ellipse is worst at."),
            ("models", f"A least-squares ellipse is still off by up to {percent(fitted[-1], 1)}; one parameter more, in a superellipse or a quartic, leaves "
             f"{percent(quartics[0], 1)} to {percent(superellipses[-1], 1)}. Limits of force and moment that know nothing of each other "
             f"(the box) are too strong by up to {percent(boxes[-1], 0)}."),
        ], ""),
        ("Look-up tables", [
            ("tables", f"Left: bytes against tolerance. Right: the error between the nodes of a table of {short(certified)} stays inside the "
             f"tolerance (grey); the largest found here is {worst_between:.1e}."),
        ], "<p>The tables for Table 1 of the paper (Kinoshita et al., J. Neurophysiol. 78:1619–1630, 1997). The radius is the one that "
           "the measured ratio μ<sub>r</sub>/μ implies under the law; it exceeds a fingertip’s, so keep μ<sub>r</sub> itself where it was "
           "measured.</p>" + materials_table(data)),
        ("A god-object that obeys the curve", [
            ("god_object", "The god-object’s offset from its goal on three scripted motions, with the p-curves of several loads: a pure "
             "drag stays on the axis of r, a pure twist on that of ρ, and both boundaries agree there. In the third the finger slides and "
             "turns while the load falls to a third and rises again."),
            ("repositioning", "Single steps of that slip, magnified (the paper’s Fig. 5). The goal moves on, which leaves the god-object "
             "outside the p-curve of the step’s load (diamonds); it is moved back on to it (dots): along the ray to the origin, or to the "
             "closest point, which lies at a right angle in these axes, scaled by the springs’ energy."),
            ("felt", "What the finger feels. Shaded: slip, by the exact curve. Where motion is combined, the radial ellipse gives another "
             f"force and moment (law {html.escape(run['law'])}, μ = {run['mu']:g}, k<sub>l</sub> = {run['stiffness']:g} N/m, "
             f"k<sub>r</sub> = {run['twist_stiffness']:g} N m/rad)."),
        ], ""),
        ("The projection matters more than the curve", [
            ("steady_twist", f"A finger (law {html.escape(twist['law'])}) is driven at a constant twist about a centre at c = {twist['cor']:g} a "
             "until the wrench is steady. Physics says the wrench of eq. (17) at that centre of rotation. The closest point gives it at every stiffness; the radial projection gives a wrench set by the "
             "ratio of the springs, whatever the curve. On the ellipse the closest point is off by the ellipse’s own error."),
        ], ""),
        experiment_figures.section(data),
        ("From measurements to parameters", [
            ("fits", "A synthetic sensor log with a few gross outliers (data/fit/slips.csv) and the limit curve fitted to it by a robust "
             "loss: friction, moment coefficient and the growth of the contact with the load, each with its standard error; the 95 % "
             "band is hardly wider than the line (lens). Grey on the right: where 95 % of the residuals of a right model lie."),
        ], fits_table(data)),
        ("Contacts that are not round", [
            ("patches", "Left: measurements that nobody here made. A plate on three known points was pushed over hardboard and plywood; what "
             "each push needs of power, over the power H of the three points (blue) and of the ellipsoid √(v² + m₀²ω²) (orange), must be "
             f"one friction coefficient, however much of the motion is rotation. Nothing is fitted. Its drift over the share of rotation is {drifts[0]} for the points and "
             f"{drifts[1]} for the ellipsoid. That shows how force and moment couple; it does not show the pressure "
             "under a soft pad, nor pure spin, and the directions of the wrenches scatter too much to tell the models apart. Right: when a round "
             f"model will do. The best disc of all laws and radii is off by {percent(square['max_error'], 1)} for a square and "
             f"{percent(long['max_error'], 0)} for a rectangle 5 : 1."),
        ], patch_fits_table(data)),
        ("Speed against accuracy", [
            ("work_precision", "One dot for every way to a friction wrench: its largest error over every centre of rotation, as a share of what "
             "the contact bears, against its cost on one machine; filled ours, hollow others’. Bands: the cheapest at each error. Last, a "
             "step of the god-object: its error is that of the steady wrench under a constant twist, over stiffness ratios and centres of "
             "rotation a decade to either side of one."),
        ], ""),
        ("The same finger in a physics engine", [
            ("engines", "Measured: a finger dragged in the engines themselves about imposed centres of rotation, with the coefficients that "
             "<code>limitcurve translate</code> gives. MuJoCo’s elliptic cone is the ellipse and its default pyramid the diamond; ODE and "
             "Bullet limit force and moment each on its own (the box), so that all their wrenches but the two ends lie in its corner. The "
             "limits of pure force and pure moment are right in all of them, in MuJoCo’s pyramid for slips of 30 mm/s and more; right: what is "
             "wrong in between. data/engines/errors.csv has the other engines that were dragged."),
        ],
         f"<p>What to type into an engine for a finger of the {html.escape(engine['law'])} law, a(P) by "
         f"{html.escape(engine['radius_law'])}, μ = {engine['mu']:g}, at a load of {engine['load']:g} N, and how far its own limit curve "
         "then remains from the exact one.</p>" + engines_table(data)),
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
        text = page(data, numbers_to_remember(data), sections(data), pictures, touch, FILES)
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
