"""One of many patches shown at a time, chosen in a table of positions and wheels; without a script."""
from html import escape

from . import places
from .tables import plain


def _cells(scenes, name):
    """{(position, wheel): labels that choose its patches}."""
    cells = {}
    for number, (_, scene) in enumerate(scenes, 1):
        place = scene.models[0].place
        cells.setdefault((place["position"], place["wheel"]), []).append(
            f'<label for="{name}{number}">{place["patch"]:.0f}</label>')
    return cells


def _table(result, scenes, name):
    at, label = places.along(result)
    cells = _cells(scenes, name)
    wheels = [wheel for wheel in ("left", "right") if any(key[1] == wheel for key in cells)]
    numbers = sorted({key[0] for key in cells})
    head = f"<th scope=col>{escape(label.replace(' of the wheelset', ''))}</th>" + "".join(
        f"<th scope=col>{plain(at[position])}</th>" for position in numbers)
    rows = "".join(
        f"<tr><th scope=row>{wheel} wheel</th>" + "".join(
            f"<td>{''.join(cells.get((position, wheel), ['–']))}</td>" for position in numbers) + "</tr>"
        for wheel in wheels)
    return (f'<div class="wide chooser" role=region tabindex=0 aria-label="choose a patch"><table><thead><tr>{head}'
            f"</tr></thead><tbody>{rows}</tbody></table></div>")


def chooser(result, scenes, articles, name, all_on_paper):
    """`articles`: HTML of each of the scenes; `name`: of the choice, unlike others of the page. Where few
    are, the printer gets all."""
    inputs, rules, parts = [], [], []
    for number, ((label, _), article) in enumerate(zip(scenes, articles), 1):
        this = f"{name}{number}"
        inputs.append(f'<input type=radio class=pick name="{name}" id="{this}" aria-label="{escape(label)}"'
                      f'{" checked" if number == 1 else ""}>')
        rules.append(f"#{this}:checked~#of-{this}{{display:block}}"
                     f"#{this}:checked~.chooser [for={this}]{{background:var(--accent);color:var(--ground)}}"
                     f"#{this}:focus-visible~.chooser [for={this}]{{outline:2px solid var(--ink)}}")
        parts.append(f'<article class=patch id="of-{this}">{article}</article>')
    if all_on_paper:
        rules.append("@media print{.patch{display:block}}")
    return (f"<section aria-label=\"Patches\"><style>{''.join(rules)}</style>{''.join(inputs)}"
            "<p class=hint>Choose a patch (1: the most loaded of its wheel); arrow keys go along the row.</p>"
            f"{_table(result, scenes, name)}{''.join(parts)}</section>")
