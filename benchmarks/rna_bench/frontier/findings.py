"""Summary of a frontier: our models against the paper's two."""

from typing import Any

Points = list[dict[str, Any]]


def findings(points: Points) -> dict[str, Any]:
    """Our cheapest model as accurate as `paper-hq`, our best one as cheap as `paper-small`.

    A part is None where there is no such model, or where its costs were not measured.
    """
    timed = [p for p in points if p["ns"] is not None]
    ours = [p for p in timed if p["family"] == "ours"]
    return {
        "as_accurate_as_paper_hq": _cheaper(ours, _named(timed, "paper-hq")),
        "as_cheap_as_paper_small": _better(ours, _named(timed, "paper-small")),
    }


def sentences(result: dict[str, Any]) -> list[str]:
    """The findings in words."""
    said = []
    if cheaper := result["as_accurate_as_paper_hq"]:
        said.append(
            f"At the accuracy of paper-hq ({cheaper['paper_psnr']:.1f} dB, "
            f"{cheaper['paper_ns']:,.0f} ns/query) the cheapest of ours is {cheaper['name']}: "
            f"{cheaper['psnr']:.1f} dB, {cheaper['ns']:,.0f} ns, "
            f"1/{cheaper['times_as_cheap']:.0f} of the cost."
        )
    if better := result["as_cheap_as_paper_small"]:
        said.append(
            f"At the cost of paper-small ({better['paper_ns']:,.0f} ns/query, "
            f"{better['paper_psnr']:.1f} dB) the best of ours is {better['name']}: "
            f"{better['psnr']:.1f} dB, {better['db_better']:+.1f} dB, {better['ns']:,.0f} ns."
        )
    return said


def _cheaper(ours: Points, paper: dict[str, Any] | None) -> dict[str, Any] | None:
    good = [p for p in ours if paper and p["psnr"] >= paper["psnr"]]
    if not good or not paper:
        return None
    result = min(good, key=lambda p: p["ns"])
    return {**_pair(result, paper), "times_as_cheap": paper["ns"] / result["ns"]}


def _better(ours: Points, paper: dict[str, Any] | None) -> dict[str, Any] | None:
    cheap = [p for p in ours if paper and p["ns"] <= paper["ns"]]
    if not cheap or not paper:
        return None
    result = max(cheap, key=lambda p: p["psnr"])
    return {**_pair(result, paper), "db_better": result["psnr"] - paper["psnr"]}


def _pair(ours: dict[str, Any], paper: dict[str, Any]) -> dict[str, Any]:
    return {
        "name": f"{ours['name']} {ours['precision']}",
        "ns": ours["ns"],
        "psnr": ours["psnr"],
        "paper_ns": paper["ns"],
        "paper_psnr": paper["psnr"],
    }


def _named(points: Points, name: str) -> dict[str, Any] | None:
    return next((p for p in points if p["name"] == name), None)
