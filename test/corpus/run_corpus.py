#!/usr/bin/env python3
"""Runs the command on every model of some folders and prints one line per model and a summary.

    run_corpus.py --program build/examples/quad_layout [--data DIR ...] [--models NAME ...] [--features DEG]
                  [--metrics quad_metrics.py] [--route field|parametrization] [--strict] [--jobs 2] [--seconds S]
                  [--output DIR] [--table FILE]

A model passes if the command succeeds, the map is valid, no T-junction is left and, with --metrics (a program that measures
a quad mesh and prints JSON), the independent measures agree with stats.json. With --features edges sharper than the angle
are kept, and no point of them or of the border may be farther from the edges of the quads than a thousandth of the bounding
box's diagonal. With --strict every model also runs with maximum displacement 0, and must not have fewer patches than with
the default. What is no oriented manifold of triangles has to be refused for the right reason, and to pass after --repair.
Exit status: the number of failures, at most 100.
"""
import argparse
import concurrent.futures
import fractions
import glob
import itertools
import json
import os
import resource
import subprocess
import sys
import time

COLUMNS = ("model", "route", "faces", "S in", "S out", "floor", "P r=0", "P", "quads", "MSJ min", "MSJ avg", "feature",
           "field", "trace", "quantize", "embed", "smooth", "total", "status", "gap", "verdict")


PYTHON = "/usr/bin/python3"        # the one that numpy is installed for
GREATEST_FEATURE_DISTANCE = 1e-3


def run(options, model, out, *more):
    """Run the command; return (statistics or None, its last line on stderr, seconds)."""
    start = time.time()
    command = [options.program, model, "--output", out, "--quiet", *more]
    if options.features:
        command += ["--features", str(options.features)]
    if options.route:
        command += ["--route", options.route]
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


def output_of(model, options, repair=False):
    """Name the folder for what is made of a model; files of one name may be in several folders."""
    folder, file = os.path.split(os.path.abspath(model))
    return os.path.join(options.output, os.path.basename(folder), os.path.splitext(file)[0] + " repaired" * repair)


def examine(model, options, repair=False):
    """Run one model; return its row of the table and whether it passed."""
    out = output_of(model, options, repair)
    how = ["--repair"] if repair else []
    stats, reason, seconds = run(options, model, out, *how)
    row = dict.fromkeys(COLUMNS, "")
    row["model"] = os.path.basename(out)
    if stats is None:
        row.update(total="%.1f" % seconds, verdict=reason)
        return row, False
    spent, program = stats["seconds"], stats["program"]
    row.update({"route": stats["route"], "faces": stats["input"]["faces"], "S in": stats["singularities_in"],
                "S out": stats["singularities_out"], "floor": stats["patches_floor"], "P": stats["patches"],
                "quads": stats["quads"], "MSJ min": "%.3f" % stats["msj_min"],
                "MSJ avg": "%.4f" % stats["msj_avg"], "status": program["status"],
                "gap": "%.3g" % program["gap"] if program["gap"] is not None else "-"},
               **{key: "%.1f" % spent[key] for key in ("field", "trace", "quantize", "embed", "smooth", "total")})
    faults = [f"{key} {stats['map'][key]}" for key in ("inverted", "wrong_winding") if stats["map"][key]]
    if stats["t_junctions"]:
        faults.append("T-junctions")
    if not repair:                                      # which changes the surface
        if options.metrics:
            faults += disagreements(stats, options.metrics, model, out, options.features)
        if options.features or stats["input"]["borders"] > 0:
            distance = feature_distance(model, out, options.features or 180)
            row["feature"] = "%.1e" % distance
            if distance > GREATEST_FEATURE_DISTANCE:
                faults.append("features are %.2g away" % distance)
    if options.strict:
        strict, reason, _ = run(options, model, out + "-strict", "--displacement", "0", *how)
        row["P r=0"] = strict["patches"] if strict else "fails"
        if strict is None:
            faults.append("r = 0: " + reason)
        elif strict["patches"] < stats["patches"]:
            faults.append("fewer patches with r = 0")
    row["verdict"] = "; ".join(faults) or "ok"
    return row, not faults


def read_off(model):
    """Read a mesh in OFF; return its points and the corners of its faces."""
    with open(model, encoding="utf-8", errors="replace") as stream:
        lines = [words for words in (line.split("#")[0].split() for line in stream) if words]
    if len(lines[0]) == 1:                   # "OFF", "COFF", ... may share a line with the counts
        lines[:2] = [lines[0] + lines[1]]
    vertices, faces = int(lines[0][1]), int(lines[0][2])
    points = [tuple(map(fractions.Fraction, line[:3])) for line in lines[1:1 + vertices]]
    corners = [tuple(map(int, line[1:1 + int(line[0])])) for line in lines[1 + vertices:1 + vertices + faces]]
    return points, corners


def has_no_area(a, b, c):
    """Tell exactly whether three points are on a line."""
    u, v = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
    return all(u[i] * v[j] == u[j] * v[i] for i, j in ((0, 1), (1, 2), (2, 0)))


def number_of_fans(edges):
    """Count the connected parts of a graph that is given by its edges."""
    part = {x: x for edge in edges for x in edge}

    def find(x):
        while part[x] != x:
            x = part[x]
        return x

    for x, y in edges:
        part[find(x)] = find(y)
    return len({find(x) for x in part})


def defects(model):
    """Find out why the command has to refuse a model; return words of its messages, none for a mesh that it has to take."""
    points, faces = read_off(model)
    result = set()
    sides, around = {}, {}
    for face in faces:
        if len(set(face)) < len(face):
            result.add("twice")
        elif len(face) == 3 and has_no_area(*(points[v] for v in face)):
            result.add("has no area")
        for k, v in enumerate(face):
            before, after = face[k - 1], face[(k + 1) % len(face)]
            sides.setdefault((v, after), []).append(face)
            around.setdefault(v, []).append((before, after))
    if any(len(face) != 3 for face in faces):
        result.add("sides")
    if len({tuple(sorted(face)) for face in faces}) < len(faces):
        result.add("have the same vertices")
    if any(len(f) + len(sides.get((w, v), [])) > 2 for (v, w), f in sides.items()):
        result.add("not manifold")
    if any(len(f) > 1 for f in sides.values()):
        result.add("not oriented alike")
    if not result & {"not manifold", "have the same vertices"} and any(number_of_fans(e) > 1 for e in around.values()):
        result.add("several fans")
    return result


def examine_refused(model, words, options):
    """Check that the command refuses a model for one of the right reasons."""
    out = output_of(model, options)
    stats, reason, seconds = run(options, model, out)
    row = dict.fromkeys(COLUMNS, "")
    passed = stats is None and any(w in reason for w in words)
    row.update(model=os.path.basename(out), total="%.1f" % seconds,
               verdict=("ok, refused: " if passed else "not refused for " + ", ".join(sorted(words)) + ": ") + reason)
    return row, passed


def rows_of(model, options):
    """Examine a model, both as it is and repaired if it has to be refused."""
    words = defects(model)
    if not words:
        return [examine(model, options)]
    return [examine_refused(model, words, options), examine(model, options, repair=True)]


def select(options):
    """List the model files."""
    files = sorted(f for folder in options.data for f in glob.glob(os.path.join(folder, "*.off")))
    if options.models:
        files = [f for f in files if os.path.splitext(os.path.basename(f))[0] in options.models]
    return files


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--data", nargs="+", default=[os.path.join(os.environ.get("CGAL_DATA_DIR", "."), "meshes")])
    parser.add_argument("--models", nargs="*")
    parser.add_argument("--features", type=float, default=0, help="the angle of sharp edges, in degrees")
    parser.add_argument("--seconds", type=float, default=1800, help="that a model may take")
    parser.add_argument("--metrics")
    parser.add_argument("--route", help="that of the command if not given")
    parser.add_argument("--strict", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--output", default="corpus")
    parser.add_argument("--table", help="also write the rows to this file, separated by tabs")
    options = parser.parse_args()
    files = select(options)
    if not files:
        print("no models found: skipped")
        return 0
    failures = lines = 0
    table = open(options.table, "w", encoding="utf-8") if options.table else None
    print(" ".join(COLUMNS))
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row, passed in itertools.chain.from_iterable(pool.map(lambda model: rows_of(model, options), files)):
            lines += 1
            failures += not passed
            line = [str(row[key]) for key in COLUMNS]
            print(" ".join(text or "-" for text in line), flush=True)
            if table:
                print("\t".join(line), file=table, flush=True)
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print(f"largest memory of one run: {memory:.0f} MB")
    print(f"{lines - failures} passed, {failures} failed")
    return min(failures, 100)


if __name__ == "__main__":
    sys.exit(main())
