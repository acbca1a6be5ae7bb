#!/usr/bin/env python3
"""Runs the command on every model of some folders and prints one line per model and a summary.

    run_corpus.py --program build/examples/quad_layout [--data DIR ...] [--models NAME ...] [--features DEG]
                  [--metrics quad_metrics.py] [--strict] [--jobs 2] [--seconds S] [--output DIR] [--table FILE]

A model passes if the command succeeds, the map is valid, no T-junction is left and, with --metrics (a program that measures
a quad mesh and prints JSON), the independent measures agree with stats.json. With --features edges sharper than the angle
are kept, and no point of them or of the border may be farther from the edges of the quads than a thousandth of the bounding
box's diagonal. With --strict every model also runs with maximum displacement 0, and must not have fewer patches than with
the default. Exit status: the number of failures, at most 100.
"""
import argparse
import concurrent.futures
import glob
import json
import os
import resource
import subprocess
import sys
import time

COLUMNS = ("model", "faces", "S in", "S out", "floor", "P r=0", "P", "quads", "MSJ min", "MSJ avg", "feature",
           "field", "trace", "quantize", "embed", "smooth", "total", "status", "gap", "verdict")


PYTHON = "/usr/bin/python3"        # the one that numpy is installed for
GREATEST_FEATURE_DISTANCE = 1e-3


def run(options, model, out, *more):
    """Run the command; return (statistics or None, its last line on stderr, seconds)."""
    start = time.time()
    command = [options.program, model, "--output", out, "--quiet", *more]
    if options.features:
        command += ["--features", str(options.features)]
    try:
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              timeout=options.seconds)
    except subprocess.TimeoutExpired:
        return None, "not done after %g s" % options.seconds, time.time() - start
    if done.returncode != 0:
        last = (done.stderr.strip().splitlines() or ["exit status %d" % done.returncode])[-1]
        return None, last, time.time() - start
    with open(os.path.join(out, "stats.json"), encoding="utf-8") as stream:
        return json.load(stream), "", time.time() - start


def feature_distance(surface, out, angle):
    """Return how far the feature curves and the border are from the edges of quads, by the diagonal."""
    program = os.path.join(os.path.dirname(os.path.abspath(__file__)), "feature_distance.py")
    done = subprocess.run([PYTHON, program, surface, os.path.join(out, "quad_mesh.obj"), str(angle)],
                          capture_output=True, text=True, check=True)
    return float(done.stdout)


def disagreements(stats, metrics, surface, out, features):
    """Measure the quad mesh independently; return what differs from stats.json or is invalid. The measures know nothing
    of features."""
    done = subprocess.run([PYTHON, metrics, os.path.join(out, "quad_mesh.obj"), "--surface", surface],
                          capture_output=True, text=True)
    if done.returncode != 0:
        return ["metrics failed: " + done.stderr.strip()]
    found = json.loads(done.stdout)
    wanted = {"non_quads": 0, "non_manifold_edges": 0, "non_manifold_vertices": 0, "inverted_quads": 0,
              "quads_against_surface": 0, "oriented": True, "euler": stats["input"]["euler"], "quads": stats["quads"],
              "components": stats["input"]["components"]}
    if stats["input"]["borders"] == 0:
        wanted.update({"boundary_edges": 0, "irregular_interior": stats["singularities_out"]})
        if not features:
            wanted["base_complex_patches"] = stats["patches"]
    return [f"{key} is {found[key]}, not {value}" for key, value in wanted.items() if found[key] != value]


def examine(model, options):
    """Run one model; return its row of the table and whether it passed."""
    name = os.path.splitext(os.path.basename(model))[0]
    folder = os.path.basename(os.path.dirname(os.path.abspath(model)))      # names may occur in several
    out = os.path.join(options.output, folder, name)
    stats, reason, seconds = run(options, model, out)
    row = dict.fromkeys(COLUMNS, "")
    row["model"] = name
    if stats is None:
        row.update(total="%.1f" % seconds, verdict=reason)
        return row, False
    spent, program = stats["seconds"], stats["program"]
    row.update({"faces": stats["input"]["faces"], "S in": stats["singularities_in"],
                "S out": stats["singularities_out"], "floor": stats["patches_floor"], "P": stats["patches"],
                "quads": stats["quads"], "MSJ min": "%.3f" % stats["msj_min"],
                "MSJ avg": "%.4f" % stats["msj_avg"], "status": program["status"],
                "gap": "%.3g" % program["gap"] if program["gap"] is not None else "-"},
               **{key: "%.1f" % spent[key] for key in ("field", "trace", "quantize", "embed", "smooth", "total")})
    faults = [f"{key} {stats['map'][key]}" for key in ("inverted", "wrong_winding") if stats["map"][key]]
    if stats["t_junctions"]:
        faults.append("T-junctions")
    if options.metrics:
        faults += disagreements(stats, options.metrics, model, out, options.features)
    if options.features or stats["input"]["borders"] > 0:
        distance = feature_distance(model, out, options.features or 180)
        row["feature"] = "%.1e" % distance
        if distance > GREATEST_FEATURE_DISTANCE:
            faults.append("features are %.2g away" % distance)
    if options.strict:
        strict, reason, _ = run(options, model, out + "-strict", "--displacement", "0")
        row["P r=0"] = strict["patches"] if strict else "fails"
        if strict is None:
            faults.append("r = 0: " + reason)
        elif strict["patches"] < stats["patches"]:
            faults.append("fewer patches with r = 0")
    row["verdict"] = "; ".join(faults) or "ok"
    return row, not faults


def is_oriented(model):
    """Tell whether a mesh in OFF has only triangles, of which no two have an edge in the same direction."""
    with open(model, encoding="utf-8", errors="replace") as stream:
        lines = [words for words in (line.split("#")[0].split() for line in stream) if words]
    try:
        if len(lines[0]) == 1:                   # "OFF", "COFF", ... may share a line with the counts
            lines[:2] = [lines[0] + lines[1]]
        vertices, faces = int(lines[0][1]), int(lines[0][2])
        corners = [face[1:4] for face in lines[1 + vertices:1 + vertices + faces] if face[0] == "3"]
        edges = {edge for c in corners for edge in zip(c, c[1:] + c[:1])}
    except (ValueError, IndexError):
        return False
    if len(corners) != faces:
        return False
    return faces > 0 and len(edges) == 3 * faces


def select(options):
    """List the model files."""
    files = sorted(f for folder in options.data for f in glob.glob(os.path.join(folder, "*.off")))
    if options.models:
        files = [f for f in files if os.path.splitext(os.path.basename(f))[0] in options.models]
    oriented = [f for f in files if is_oriented(f)]
    left_out = [os.path.basename(f) for f in files if f not in oriented]
    if left_out:
        print("left out, as no oriented meshes of triangles:", *left_out)
    return oriented


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--data", nargs="+", default=[os.path.join(os.environ.get("CGAL_DATA_DIR", "."), "meshes")])
    parser.add_argument("--models", nargs="*")
    parser.add_argument("--features", type=float, default=0, help="the angle of sharp edges, in degrees")
    parser.add_argument("--seconds", type=float, default=600, help="that a model may take")
    parser.add_argument("--metrics")
    parser.add_argument("--strict", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--output", default="corpus")
    parser.add_argument("--table", help="also write the rows to this file, separated by tabs")
    options = parser.parse_args()
    files = select(options)
    if not files:
        print("no models found: skipped")
        return 0
    failures = 0
    table = open(options.table, "w", encoding="utf-8") if options.table else None
    print(" ".join(COLUMNS))
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row, passed in pool.map(lambda model: examine(model, options), files):
            failures += not passed
            line = [str(row[key]) for key in COLUMNS]
            print(" ".join(text or "-" for text in line), flush=True)
            if table:
                print("\t".join(line), file=table, flush=True)
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print(f"largest memory of one run: {memory:.0f} MB")
    print(f"{len(files) - failures} passed, {failures} failed")
    return min(failures, 100)


if __name__ == "__main__":
    sys.exit(main())
