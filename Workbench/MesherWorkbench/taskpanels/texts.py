"""What the panel of a mesh object says."""
import html
import json

from ..messages import translated


_MOST_PLACES = 5


def estimate_text(estimate, is_volume):
    kind = translated("tetrahedra") if is_volume else translated("triangles")
    expected = (translated("Expected: at least {count} {kind}, {memory}, {time}") if estimate["at_least"]
                else translated("Expected: about {count} {kind}, {memory}, {time}"))
    return expected.format(
        count=_rounded(estimate["elements"]), kind=kind, memory=_memory(estimate["bytes"]), time=_time(estimate["seconds"]))


def stage_text(stage, seconds):
    return f"{stage[:1].upper()}{stage[1:]}, {_time(seconds)}" if stage else translated("beginning")


def done_text(seconds):
    return translated("done in {time}").format(time=_time(seconds))


def summary_of(obj):
    """A table of what the mesh object holds; nothing if it holds no mesh."""
    if not obj.ElementCount:
        return ""
    report = json.loads(obj.Report) if obj.Report else {}
    quality = report.get("quality", {})
    is_volume = "min_dihedral" in quality
    rows = [(translated("Tetrahedra") if is_volume else translated("Triangles"), f"{obj.ElementCount:,}"),
            (translated("Nodes"), f"{obj.NodeCount:,}"),
            (translated("Dihedral angles") if is_volume else translated("Angles"),
             f"{obj.SmallestAngle:.1f}° – {obj.LargestAngle:.1f}°")]
    volume, wanted = report.get("mesh", {}).get("volume"), report.get("model", {}).get("volume")
    if is_volume and volume and wanted:
        rows.append((translated("Volume"), translated("{share:.3f} % of the shape's").format(share=100.0 * volume / wanted)))
    cells = "".join(f"<tr><td>{name}&nbsp;&nbsp;</td><td align='right'><b>{value}</b></td></tr>" for name, value in rows)
    warnings = "".join(f"<p>{html.escape(text)}</p>" for text in report.get("warnings", []))
    stale = f"<p><b>{translated('The shape has changed since: mesh it again.')}</b></p>" if obj.IsStale else ""
    stiff = f"<p>{translated('Linear tetrahedra are stiff in bending: compare with half the size.')}</p>" if is_volume and obj.ElementOrder == "1st" else ""
    return f"{stale}<table>{cells}</table>{_left_of(report)}{warnings}{stiff}"


def _left_of(report):
    """Where elements stayed worse than was asked for, why, and what to do about it; a link leads to each place."""
    places = report.get("left", {}).get("places", [])
    lines = []
    for number, place in enumerate(places[:_MOST_PLACES]):
        smallest, largest = (place.get(f"{end}_dihedral", place.get(f"{end}_angle")) for end in ("min", "max"))
        angles = f", {smallest:.1f}° – {largest:.1f}°" if smallest is not None and largest is not None else ""
        lines.append(translated("<a href='{number}'>{count:,} elements at {entities}</a>{angles}: {reason}. {remedy}.").format(
            number=number, count=place["count"], entities=html.escape(", ".join(place["entities"])), angles=angles,
            reason=html.escape(place["reason"]), remedy=html.escape(place["remedy"][:1].upper() + place["remedy"][1:])))
    more = len(places) - len(lines)
    if more > 0:
        lines.append(translated("… and {count} places more, in the object's Report").format(count=more))
    return "".join(f"<p>{line}</p>" for line in lines)


def histogram_of(obj):
    quality = (json.loads(obj.Report) if obj.Report else {}).get("quality", {})
    return quality.get("dihedral_histogram") or quality.get("angle_histogram") or []


def _rounded(number):
    """Two digits; more would promise what an estimate does not hold."""
    digits = len(str(int(number)))
    return f"{int(round(number, 2 - digits)) if digits > 2 else int(number):,}"


def _memory(size):
    return f"{size / 1e9:.1f} GB" if size >= 1e9 else f"{max(1, round(size / 1e6)):,} MB"


def _time(seconds):
    if seconds < 0.1:
        return translated("under 0.1 s")
    if seconds < 10.0:
        return f"{seconds:.1f} s"
    return f"{seconds:.0f} s" if seconds < 120.0 else f"{seconds / 60.0:.0f} min"
