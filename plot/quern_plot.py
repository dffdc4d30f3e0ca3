# SPDX-License-Identifier: Apache-2.0
"""Pictures from a run folder: what `quern plot DIR` runs.

Reads summary.json, series, fields, frames and traces of the folder and writes pictures/*.png. Each
figure is tried on its own: what a run did not record is named and skipped, so an unfinished run
gives the pictures it can. The same recordings give the same bytes.

Exit code: 0 when all that was recorded was drawn, 2 when the folder is not a run folder, 3 when a
module is missing or a recording can't be made sense of.
"""
import argparse
import os
import sys

PACKAGES = "python3-numpy python3-matplotlib python3-h5py"


def arguments():
    parser = argparse.ArgumentParser(
        prog="quern plot", description="Draws pictures from the recordings of a run.")
    parser.add_argument("folder", metavar="DIR", help="a run folder, as `quern run` leaves it")
    parser.add_argument("--format", choices=("png", "pdf", "svg"), default="png",
                        help="kind of file (default: png)")
    parser.add_argument("--dpi", type=int, default=300, help="pixels per inch of a png")
    parser.add_argument("-o", "--output", metavar="FOLDER",
                        help="where to put the pictures (default: DIR/pictures)")
    parser.add_argument("--quiet", action="store_true", help="say nothing but errors")
    return parser.parse_args()


def main():
    args = arguments()
    sys.dont_write_bytecode = True  # the program may be installed where nothing may be written
    try:
        from figures import figure_list
        from figures.folder import NotRun, Run
        from figures.style import Gallery
        from figures.table import NotRecorded
    except ImportError as error:
        print(f"quern plot: {error}; on Debian: apt install {PACKAGES}", file=sys.stderr)
        return 3
    try:
        run = Run(args.folder)
        gallery = Gallery(args.output or os.path.join(args.folder, "pictures"),
                          args.format, args.dpi)
    except (NotRun, OSError) as error:
        print(f"quern plot: {error}", file=sys.stderr)
        return 2
    skipped, broken = [], []
    for name, draw in figure_list():
        try:
            draw(run, gallery)
        except NotRecorded as reason:
            skipped.append((name, str(reason)))
        except (OSError, KeyError, ValueError, IndexError) as error:
            broken.append(f"{name}: {type(error).__name__}: {error}")
    if not args.quiet:
        report(gallery.written, skipped)
    for line in broken:
        print(f"quern plot: {line}", file=sys.stderr)
    return 3 if broken else 0


def report(written, skipped):
    for path in written:
        print(f"  {path}")
    for reason in dict.fromkeys(why for _, why in skipped):
        names = ", ".join(name for name, why in skipped if why == reason)
        print(f"  not drawn: {names} ({reason})")
    if not written:
        print("  nothing to draw yet")


if __name__ == "__main__":
    sys.exit(main())
