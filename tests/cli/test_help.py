# SPDX-License-Identifier: Apache-2.0
"""`quern help` and `quern new`: what they print is right, and the templates run."""
import pathlib
import re

from common import INPUT, SOURCE, main, quern, run, summary, test, write

COMMANDS = "new check run plot info help".split()


@test("help lists every command, and explains each")
def commands():
    listed = quern("help").expect(0)
    for name in COMMANDS:
        assert f"quern {name}" in listed.out, name
        own = quern("help", name).expect(0)
        assert own.out.startswith(f"usage: quern {name}") and own.err == "", own.out
        assert quern(name, "--help").expect(0).out == own.out
    assert quern("--help").expect(0).out == listed.out == quern().expect(0).out


@test("help run names every option that run takes")
def options():
    text = quern("help", "run").expect(0).out
    for option in "-o --threads --until --steps --resume --force --quiet --no-pictures".split():
        assert f"\n  {option}" in text, option


@test("help plot names every option that plot takes")
def plot_options():
    text = quern("help", "plot").expect(0).out
    script = (SOURCE / "plot" / "quern_plot.py").read_text()
    options = re.findall(r'add_argument\("(-[-\w]+)"', script)
    assert len(options) >= 4, options
    for option in options:
        assert f"\n  {option}" in text, option


@test("help of a part of a scene lists its keys and no others")
def part():
    for name, keys, others in (("drum", "diameter speed face_angle", "young"),
                               ("lifters", "face_angle", "speed"),
                               ("feeds", "rate", "young"), ("feed", "rate", "young"),
                               ("walls", "normal frequency", "young"),
                               ("motion", "frequency", "normal")):
        lines = [line.split() for line in quern("help", name).expect(0).out.splitlines()]
        found = {words[0] for words in lines if words}
        assert set(keys.split()) <= found and others not in found, (name, found)
    quern("help", "drums").expect(INPUT, "did you mean 'drum'?")


@test("help for an unknown word names the nearest and exits with 2")
def unknown():
    done = quern("help", "rum").expect(INPUT, "no command 'rum'; did you mean 'run'?", "quern check")
    assert done.out == ""
    done = quern("help", "nonsense").expect(INPUT, "no command 'nonsense'\n", "quern check")
    assert done.out == ""
    quern("help", "sceen").expect(INPUT, "did you mean 'scene'?")
    quern("help", "run", "fast").expect(INPUT, "'fast' is one word too many")
    quern("help", "scene", "--html").expect(INPUT, "'--html' is one word too many")


@test("help scene lists the keys, and its page in docs is up to date")
def scene():
    text = quern("help", "scene").expect(0).out
    for key in "young poisson restitution filling lifters checkpoint".split():
        assert key in text, key
    page = quern("help", "scene", "--markdown").expect(0).out
    assert page == (SOURCE / "docs" / "scene.md").read_text(), "docs/scene.md is not up to date"


@test("--version prints the version")
def version():
    assert quern("--version").expect(0).out.startswith("quern ")


def template(name):
    text = quern("new", name).expect(0).out
    assert text.lstrip().startswith("#") and "format: quern-scene/1" in text
    path = write(f"{name}.yaml", text)
    done = quern("check", path).expect(0)
    assert done.err == "", done.err
    run(path, "out", "--steps", 30, "--no-pictures").expect(0)
    assert summary("out")["steps"] == 30
    assert sorted(p.name for p in pathlib.Path(".").iterdir()) == [f"{name}.yaml", "out"]


@test("the template of a mill passes the check and runs")
def mill():
    template("mill")
    assert quern("new").expect(0).out == pathlib.Path("mill.yaml").read_text()


@test("the template of a drop passes the check and runs")
def drop():
    template("drop")


@test("an unknown template is told, with the nearest")
def unknown_template():
    done = quern("new", "mil").expect(INPUT, "mil", "'mill'")
    assert done.out == ""
    quern("new", "mill", "drop").expect(INPUT, "drop")


@test("every scene that is shipped passes the check")
def shipped():
    scenes = sorted((SOURCE / "scenes").glob("*.yaml"))
    assert len(scenes) >= 9
    for path in scenes:
        quern("check", path).expect(0)


main()
