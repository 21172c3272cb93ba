# SPDX-License-Identifier: MIT
"""The report's figure of contacts that are not round."""

from .chart_style import BLUE, FAINT, GREEN, ORANGE, pair

SETS = {"tripod_hardboard_a": ("hardboard", "o"), "tripod_plywood_a": ("plywood", "^")}
MODELS = {"exact": ("points, exactly", BLUE, ""), "ellipsoid": ("ellipsoid", ORANGE, "_ellipsoid")}


def patches(data):
    figure, (left, right) = pair(4.1)
    for name, (label, marker) in SETS.items():
        pushes = data["patch_pushes"].where(data=name)
        fits = {row["parameter"]: row["value"] for row in data["patch_fits"].where(data=name)}
        for model, (words, colour, suffix) in MODELS.items():
            # Of both models over the friction that the exact one shows.
            left.plot(pushes.column("share"), [row[model] / fits["mu"] for row in pushes],
                      marker,
                      color=colour,
                      markersize=3.5,
                      alpha=0.6,
                      label=f"{words}, {label}")
            mean, drift = fits[f"mu{suffix}"], fits[f"drift{suffix}"]
            middle = sum(pushes.column("share")) / len(pushes)
            left.plot((0, 1), [mean / fits["mu"] * (1 + drift * (share - middle)) for share in (0, 1)],
                      color=colour,
                      linewidth=1,
                      linestyle="-" if marker == "o" else "--")
    left.set(title="Friction of a plate on three points, over its mean",
             xlabel="share of rotation in the motion",
             xlim=(0, 1),
             ylim=(0.5, 1.25))
    left.legend(loc="lower left", fontsize=8)

    styles = {
        ("disc", "rectangle"): (GREEN, "-"),
        ("disc", "hertz ellipse"): (GREEN, "--"),
        ("ellipsoid", "rectangle"): (ORANGE, "-"),
        ("ellipsoid", "hertz ellipse"): (ORANGE, "--")
    }
    for (model, shape), (colour, line) in styles.items():
        rows = [row for row in data["patch_errors"].where(shape=shape) if row["model"].split(":")[0] == model]
        right.plot([row["aspect"] for row in rows], [100 * row["max_error"] for row in rows], line, color=colour,
                   label=f"{'best disc' if model == 'disc' else model}, {shape}")
    right.axhline(0, color=FAINT, linewidth=0.8)
    right.set(title="Largest error of a round model, %", xlabel="aspect of the contact", ylim=(0, None))
    right.legend(fontsize=8)
    return figure
