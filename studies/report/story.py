# SPDX-License-Identifier: MIT
"""The report's story: its figures, what to see in each, what to do about it, and tables. It only draws: each figure and
each number is a function of the CSV files, whose columns csv_files.py has."""

import html

from . import curve_figures, experiment_figures, finger_figures, patch_figures, pictures
from .chart_style import short
from .work_precision_figures import work_precision

FIGURES = {
    "what_is_computed": pictures.what_is_computed,
    "limit_curves": curve_figures.limit_curves,
    "load_curves": curve_figures.load_curves,
    "ellipse_error": curve_figures.ellipse_error,
    "models": curve_figures.models,
    "tables": curve_figures.tables,
    "god_object": finger_figures.god_object,
    "felt": finger_figures.felt,
    "steady_twist": finger_figures.steady_twist,
    "pivot": experiment_figures.pivot,
    "pivot_operator": experiment_figures.pivot_operator,
    "pivot_stiffness": experiment_figures.pivot_stiffness,
    "fits": curve_figures.fits,
    "patches": patch_figures.patches,
    "engines": curve_figures.engines,
    "work_precision": work_precision,
}


def percent(fraction, digits=2):
    return f"{100 * fraction:.{digits}f} %"


def numbers_to_remember(data):
    """The three figures a reader should take away, each with the sentences that explain it."""
    ellipses = data["validate"].where(model="ellipse")
    worst, best = (pick(ellipses, key=lambda row: row["max_over_estimate"]) for pick in (max, min))
    largest, least = percent(worst["max_over_estimate"], 1), percent(best["max_over_estimate"], 1)
    twist = data["steady_twist"]
    radial, closest = (max(twist.where(boundary="table", projection=name).column("error"))
                       for name in ("radial", "closest-point"))
    ratios = twist.column("stiffness_ratio")
    table = data["tables"].where(law="hertz", tolerance=1e-8)[0]
    error = table["checked_error"]
    look_up = data["work_precision_wrench"].where(law="hertz", family="table", parameter=1e-8)[0]["mean_ns"]
    step = data["work_precision_step"].where(boundary="table 1e-8", projection="closest-point")[0]["many_warm_ns"]
    return [
        (largest,
         f"The usual ellipse overestimates friction by up to {largest} ({worst['law']}; {best['law']}: {least}), and "
         "misplaces "
         f"the centre of rotation by up to {percent(worst_cor_error(data), 0)}."),
        (percent(radial, 0),
         f"If a finger slides straight on and turns, v/ω = a, the radial projection misses the friction by up to "
         f"{percent(radial, 0)} of its limits (stiffness ratios κ from {min(ratios):.2g} to {max(ratios):.2g}); the "
         f"closest point misses it by {closest:.0e}."),
        (f"{look_up:.0f} ns",
         f"A look-up takes {look_up:.0f} ns in a table of {table['bytes']:.0f} bytes with an error of at most "
         f"{short(float(f'{error:.1e}'))}; a finger step on it takes {step:.0f} ns. A finer table costs almost "
         "no extra time."),
    ]


def cor_ratios(rows):
    """Distance of the centre of rotation by the ellipse over the true one, where it is a number."""
    return [row["cor_ratio"] for row in rows if row["cor_ratio"] == row["cor_ratio"]]


def worst_cor_error(data):
    return max(abs(ratio - 1) for ratio in cor_ratios(data["ellipse_error"]))


def facts_table(columns, rows):
    """An HTML table; columns of numbers (that begin with a digit in every row) stand to the right, of words to the
    left."""
    numeric = [all(cell[:1].isdigit() for cell in column) for column in zip(*rows)]

    def line(tag, cells):
        marked = zip(numeric, cells)
        return "<tr>" +"".join(f"<{tag}{' class=number' if number else ''}>{cell}</{tag}>"
                               for number, cell in marked) + "</tr>"

    head, body = line("th", columns), "".join(line("td", row) for row in rows)
    return f'<table><thead>{head}</thead><tbody>{body}</tbody></table>'


def materials_table(data):
    def link(name):
        return f'<a href="{html.escape(name)}">{html.escape(name)}</a>'

    return facts_table(
        ("material", "μ", "μ<sub>r</sub> [mm]", "law", "radius a [mm]", "checked error", "nodes", "bytes", "file"),
        [(row["material"], f"{row['mu']:g}", f"{1e3 * row['mu_r']:g}", row["law"], f"{1e3 * row['radius']:.2f}",
          f"{row['checked_error']:.1e}", f"{row['nodes']:.0f}", f"{row['bytes']:.0f}", link(row["file"]))
         for row in data["materials"]])


def laws_table(data):
    rows = []
    for law in data["laws"]:
        ellipse = data["validate"].where(law=law["law"], model="ellipse")[0]
        ratios = cor_ratios(data["ellipse_error"].where(law=law["law"]))
        rows.append((law["law"], f"{law['moment_ratio']:.4g}", percent(ellipse["max_over_estimate"]),
                     f"{min(ratios):.2f} … {max(ratios):.2f}"))
    return facts_table(
        ("law", "moment ratio m<sub>0</sub>", "ellipse overestimates by", "centre of rotation, ellipse / true"), rows)


def unit_of(row):
    """A bare 1 for what has none would be read as a number."""
    return "–" if row["unit"] == 1 else html.escape(str(row["unit"])).replace("^gamma", "<sup>γ</sup>")


def engines_table(data):
    first = data["translate"][0]
    rows = [(html.escape(row["engine"]), html.escape(row["parameter"]),
             f"{row['value']:.6g}" if isinstance(row["value"], float) else row["value"], unit_of(row),
             html.escape(row["model"]), percent(row["max_error"], 1))
            for row in data["translate"].where(law=first["law"])]
    return facts_table(("engine", "parameter", "value", "unit", "limit curve", "remaining error"), rows)


def error_of(row):
    """Degrees of freedom and probabilities have none."""
    return f"{row['std_error']:.2g}" if row["std_error"] else "–"


def fits_table(data):
    return facts_table(("data", "fit", "parameter", "value", "standard error", "unit"),
                       [(row["data"], row["model"], html.escape(row["parameter"]), f"{row['value']:.5g}", error_of(row),
                         unit_of(row)) for row in data["fits"]])


def sections(data):
    ellipses = data["validate"].where(model="ellipse")
    over, boxes = sorted(ellipses.column("max_over_estimate")), data["validate"].where(model="box").column("max_error")
    worst = max(ellipses, key=lambda row: row["max_over_estimate"])["law"]
    ratios = cor_ratios(data["ellipse_error"])
    run, twist = data["replay_run"][0], data["steady_twist"][0]
    engine = data["translate"][0]
    tolerance, places = data["table_error"][0]["tolerance"], len(data["table_error"].where(law="hertz"))
    finest, largest = min(data["tables"].column("tolerance")), max(data["tables"].column("bytes"))
    drifts = [
        " and ".join(f"{row['value']:.2f} ± {row['std_error']:.2f}"
                     for row in data["patch_fits"].where(parameter=name))
        for name in ("drift", "drift_ellipsoid")
    ]
    square, long = ([
        row for row in data["patch_errors"].where(shape="rectangle", aspect=aspect) if row["model"].startswith("disc:")
    ][0] for aspect in (1, 5))
    return [
        pictures.section(),
        ("One curve for each pressure law", [
            ("limit_curves",
             """The paper’s Fig. 3 for the pressure laws of this library. A pressure law describes how the load spreads
over the contact. Scaled to its own limits, every law’s curve lies <em>inside</em> the dashed ellipse. The shapes are
much alike; the largest moments differ widely.""",
         "If you do not know the law, use hertz with your measured friction moment."),
        ], laws_table(data)),
        ("Loads and centres of rotation", [
            ("load_curves",
             """The two families of the paper’s Fig. 4. A p-curve (blue) is the limit curve at one load. A c-curve
(orange) shows force and moment about one centre of rotation as the load grows. It is straight only if the contact
radius is constant.""",
             "Give the finger its a(P); do not just scale one curve."),
        ], ""),
        ("How wrong the ellipse is", [
            ("ellipse_error",
             f"""Left: the ellipse overestimates friction by {percent(over[0], 1)} to {percent(over[-1], 1)} (worst:
{worst}). Right: it puts the centre of rotation at {min(ratios):.2f} to {max(ratios):.2f} times its true distance.""",
             "Use an ellipse for rough forces, not to predict motion after slip."),
            ("models",
             f"""Each dot is a model’s largest error, as a fraction of the true friction. The ellipse through the
limits is off by {percent(over[0], 1)} to {percent(over[-1], 1)}. A box, which limits force and moment separately,
overestimates by up to {percent(max(boxes), 0)}.""", "Use a table: you choose the error."),
        ], ""),
        ("Look-up tables", [
            ("tables",
             f"""Left: down to a tolerance of {short(finest)}, no table exceeds {largest:.0f} bytes. Right: the error
of a {short(tolerance)} table at {places} slips. It stays within the tolerance (grey).""",
             "Use a tolerance of 1e-8 and forget about the curve."),
        ], "<p>Tables for the materials of the paper’s Table 1. The radius is inferred from the measured ratio "
         "μ<sub>r</sub>/μ and the law, and is larger than a fingertip’s. If you have measured μ<sub>r</sub>, use it "
         "directly.</p>" + materials_table(data)),
        ("A god-object that obeys the curve", [
            ("god_object",
             """The god-object (proxy) is where the finger would be if it could not enter the surface. Springs pull it
towards its goal: r is their stretch, ρ their twist. Three scripted motions in the planes of the paper’s Figs. 5 and 9,
with the limit curves of several loads. A pure drag stays on the r axis, a pure twist on the ρ axis. In the third
motion the finger slides and turns while the load changes.""",
         "Compare models on combined motions. Only there do they differ."),
            ("felt",
             f"""What the user feels. Shaded: the finger slips, according to the exact curve (law
{html.escape(run['law'])}, μ = {run['mu']:g}, k<sub>l</sub> = {run['stiffness']:g} N/m, k<sub>r</sub> =
{run['twist_stiffness']:g} N m/rad).""",
             "Use a table and the closest point where a finger slides and turns at once."),
        ], ""),
        ("The projection matters more than the curve", [
            ("steady_twist",
             f"""A finger slides straight on and turns, v/ω = c = {twist['cor']:g} a. Errors are fractions of the
limits. With the closest point the wrench settles at that of eq. (17), at every stiffness; on the ellipse only the
ellipse’s own error remains. With the radial projection the ratio of the springs decides, whatever the curve. About a
centre that stays the force lags: keep k<sub>l</sub> ≫ μP/c.""",
             "Use the radial projection only if k<sub>r</sub> is near k<sub>l</sub>(μ<sub>r</sub>/μ)²."),
        ], ""),
        experiment_figures.section(data),
        ("From measurements to parameters", [
            ("fits",
             """Left: slips from a synthetic sensor log with gross outliers, and the limit curve fitted with a robust
loss. Right: the residuals. If the model is right, 95 % of them lie in the grey band.""",
         "Add <code>--loss cauchy</code> if some rows may not be slips."),
        ], fits_table(data)),
        ("Contacts that are not round", [
            ("patches",
             f"""Left: published pushes of a plate on three known points over hardboard and plywood. Measured power
divided by a model’s power is the friction coefficient; for a correct model it does not depend on the share of
rotation. It drifts by {drifts[0]} for three points (blue) and {drifts[1]} for the usual ellipsoid (orange). Nothing is
fitted. Right: the best disc is off by {percent(square['max_error'], 1)} for a square and
{percent(long['max_error'], 0)} for a 5 : 1 rectangle.""",
             "Use the patch itself, or ask <code>limitcurve choose --patch</code>."),
        ], ""),
        ("Speed against accuracy", [
            ("work_precision",
             """Each dot is one way to compute a friction wrench, on one machine. Errors are in units of μP and μPa,
like a table’s tolerance, not fractions of the limits.""",
             "Use a 1e-8 table in a loop, <code>evaluate</code> as a reference."),
        ], ""),
        ("The same finger in a physics engine", [
            ("engines",
             """We dragged a finger in the engines themselves. MuJoCo’s elliptic cone is the ellipse; its default
pyramid is the diamond. ODE and Bullet limit force and moment separately, so nearly all their wrenches lie in the box’s
corner. Pure force and pure moment are right (in the pyramid, for slips of at least 30 mm/s).""",
         "Use MuJoCo’s elliptic cone if you can."),
        ],
         f"<p>Coefficients for a finger with {html.escape(engine['law'])} pressure, a(P) by "
         f"{html.escape(engine['radius_law'])}, "
         f"μ = {engine['mu']:g}, at {engine['load']:g} N. <code>limitcurve translate</code> has formulas, and rules "
         "for two "
         "bodies.</p>" + engines_table(data)),
    ]
