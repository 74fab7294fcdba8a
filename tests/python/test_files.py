# SPDX-License-Identifier: BSD-3-Clause
"""Files: the module and the command say the same."""
import json
import os
import pathlib
import subprocess

import numpy as np
import pytest

import fca_io

COMMAND = os.environ["FCA_IO"]
EXAMPLES = pathlib.Path(os.environ["FCA_EXAMPLES"])
CHAIN = EXAMPLES / "tumvi" / "camchain.yaml"
IMU = EXAMPLES / "tumvi" / "imu.yaml"
DS = EXAMPLES / "tumvi" / "ds.yaml"


def said(*words):
    run = subprocess.run([COMMAND, *map(str, words), "--json"], capture_output=True, text=True, check=False)
    return json.loads(run.stdout)


def test_a_rig_is_what_show_says():
    rig = fca_io.read(CHAIN, parts=[IMU])
    shown = said("show", CHAIN, "--with", IMU)["files"][0]
    assert rig.format == "kalibr"
    assert [camera.name for camera in rig.cameras] == [camera["name"] for camera in shown["cameras"]]
    for camera, other in zip(rig.cameras, shown["cameras"]):
        assert camera.model == other["model"]
        assert camera.parameters == other["parameters"]
    assert len(rig.imus) == 1 and rig.imus[0].rate > 0.0
    pose = rig.pose("cam1", "cam0")
    assert pose.shape == (4, 4)
    np.testing.assert_allclose(pose @ rig.pose("cam0", "cam1"), np.eye(4), atol=1e-9)
    with pytest.raises(KeyError):
        rig.pose("cam0", "moon")


@pytest.mark.parametrize("to, words", [("orbslam3", {}), ("kalibr", {"model": "eucm"}), ("vins-fusion", {}), ("basalt", {}),
                                       ("opencv", {"max_angle": 80.0})])
def test_a_conversion_is_the_commands(tmp_path, to, words):
    conversion = fca_io.convert(fca_io.read(CHAIN, parts=[IMU]), to, **words)
    options = [f"--{key.replace('_', '-')}={value}" for key, value in words.items()]
    told = said("convert", CHAIN, "--with", IMU, "--to", to, *options, "-o", f"{tmp_path}/")
    assert conversion.verdict == told["verdict"]["word"]
    assert [reason.code for reason in conversion.reasons] == [reason["code"] for reason in told["verdict"]["reasons"]]
    for camera, other in zip(conversion.cameras, told["cameras"]):
        assert camera.target.parameters == other["parameters"]
        assert camera.error.rms == pytest.approx(other["error_px"]["rms"], rel=1e-12, abs=1e-15)
    # But for the comment that says who made it.
    def bare(data):
        return [line for line in data.splitlines() if not line.lstrip().startswith((b"#", b"//", b"<!--"))]
    written = sorted(path for path in tmp_path.iterdir())
    assert sorted(map(bare, conversion.files.values())) == sorted(bare(path.read_bytes()) for path in written)


def test_save_writes_the_files(tmp_path):
    conversion = fca_io.convert(CHAIN, "openvins", parts=[IMU])
    assert len(conversion.files) == 2
    conversion.save(tmp_path / "out")
    assert {path.name: path.read_bytes() for path in (tmp_path / "out").iterdir()} == conversion.files


def test_what_is_not_to_be_used_is_not_saved(tmp_path):
    conversion = fca_io.convert(CHAIN, "kalibr", model="pinhole")
    assert conversion.verdict == "do-not-use" and conversion.reasons
    with pytest.raises(ValueError, match="do-not-use"):
        conversion.save(tmp_path / "out")
    assert not (tmp_path / "out").exists()
    accepted = fca_io.convert(CHAIN, "kalibr", model="pinhole", accept=sorted({reason.code for reason in conversion.reasons}))
    assert accepted.verdict == "use-with-care"


def test_check_finds_what_the_command_finds():
    path = EXAMPLES / "broken.yaml"
    found = fca_io.check(path)
    told = said("check", path)["files"][0]
    assert found.verdict == told["verdict"]["word"]
    assert [(each.code, each.line, each.column) for each in found.findings] == [
        (each["code"], each.get("line"), each.get("column")) for each in told["findings"]]


def test_compare_names_what_differs(tmp_path):
    other = tmp_path / "other.yaml"
    text = CHAIN.read_text()
    camera = fca_io.read(CHAIN).cameras[0]
    fx = repr(camera.parameters["fx"])
    assert fx in text
    other.write_text(text.replace(fx, repr(camera.parameters["fx"] + 1.0), 1))
    comparison = fca_io.compare(CHAIN, other)
    assert [row[0] for row in comparison.cameras[0].differing] == ["fx"]
    assert comparison.cameras[1].identical and not comparison.identical
    assert fca_io.compare(CHAIN, CHAIN).identical


def test_fit_is_within_its_bound():
    camera = fca_io.read(DS).cameras[0]
    fit = fca_io.fit(camera, "kb4")
    assert fit.camera.model == "kb4" and not fit.exact
    random = np.random.default_rng(5)
    pixels = random.uniform([0.0, 0.0], np.array(camera.image_size) - 1.0, (2000, 2))
    apart = np.linalg.norm(fit.camera.project(camera.unproject(pixels)) - pixels, axis=1)
    assert np.nanmax(apart) <= fit.error.bound
    assert np.sqrt(np.nanmean(apart**2)) == pytest.approx(fit.error.rms, rel=0.15)
    best = fca_io.models(camera)
    assert best[0].exact and best[0].model == camera.model
    assert {row.model for row in best} >= {"kb4", "eucm"}


def test_errors_say_where(tmp_path):
    path = tmp_path / "chain.yaml"
    path.write_text("cam0:\n  camera_model: pinhole\n  intrinsics: [1.0, x]\n")
    with pytest.raises(fca_io.Error) as caught:
        fca_io.read(path)
    assert caught.value.code and caught.value.file == str(path)
    assert caught.value.line >= 1 and caught.value.column >= 1
    assert str(path) in str(caught.value)
    with pytest.raises(fca_io.Error) as caught:
        fca_io.read(tmp_path / "none.yaml")
    assert caught.value.code == "cannot-read" and caught.value.line is None


def test_requests_that_cannot_be_are_value_errors():
    for words in ({"to": "no-such-program"}, {"to": "kalibr", "model": "kb5"}, {"to": "orbslam3", "layout": "v9"}):
        with pytest.raises(ValueError):
            fca_io.convert(CHAIN, **words)
    with pytest.raises(ValueError):
        fca_io.read(CHAIN, format="no-such-format")


def test_stubs_name_what_the_module_has():
    stub = pathlib.Path(fca_io.__file__).with_suffix(".pyi").read_text()
    for name in fca_io.__all__:
        assert f"class {name}" in stub or f"def {name}(" in stub, name
        assert getattr(fca_io, name).__doc__, name
        for attribute in dir(getattr(fca_io, name)) if isinstance(getattr(fca_io, name), type) else ():
            if not attribute.startswith("_") and attribute not in dir(Exception):
                assert attribute in stub, f"{name}.{attribute}"
