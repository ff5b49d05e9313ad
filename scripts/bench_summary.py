#!/usr/bin/env python3
"""A table of what `overfly bench flight --json` said of some shots.

usage: scripts/bench_summary.py RESULT.json...
"""

import json
import sys
from pathlib import Path


def at_64_samples(result):
    return next((e for e in result["equal_error"] if e["discrete_samples"] == 64), None)


def rows(result):
    ns = result["visibility_ns_per_pixel_frame"]
    yield "triangles", f"{result['triangles']:,} of {result['full_triangles']:,}"
    yield "one kinetic line / one ray", f"{ns['kinetic']:.1f} / {ns['discrete']:.1f} ns"
    yield "crossings a pixel and frame", f"{result['crossings_per_pixel_frame']:.2f}"
    equal = at_64_samples(result)
    if equal:
        lines = f"{equal['kinetic_lines']} lines that drift {equal['kinetic_drift_px']:g} pixels"
        yield "the error of 64 samples", f"{lines}, {equal['ratio']:.1f} times as fast"
    if "end_to_end" in result:
        end = result["end_to_end"]
        yield f"a frame of {end['lines']} lines / writing it", f"{end['ratio']:.1f}"
    yield "10 times the frame rate", f"{result['frame_rate_cost'][-1]['ratio']:.2f} times the time"
    yield f"{result['threads'][-1]['threads']} threads", f"{result['threads'][-1]['ratio']:.2f} times as fast"
    yield "the same triangle", f"{100 * result['agreement']['kinetic']['same_triangle_share']:.4f} %"


def main():
    for file in map(Path, sys.argv[1:]):
        print(file.stem)
        for what, value in rows(json.loads(file.read_text())):
            print(f"  {what:<34}{value}")


if __name__ == "__main__":
    main()
