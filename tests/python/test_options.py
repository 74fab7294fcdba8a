# SPDX-License-Identifier: BSD-3-Clause
"""Each keyword of convert() and read() does what the command's option does."""
import ast
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
DS = EXAMPLES / "tumvi" / "ds.yaml"
COVARIANCE = EXAMPLES / "uncertainty" / "covariance.csv"


def told(*words):
    run = subprocess.run([COMMAND, "convert", *map(str, words), "--json", "--dry-run"], capture_output=True, text=True, check=False)
    return json.loads(run.stdout)


def same_cameras(conversion, said):
    assert conversion.verdict == said["verdict"]["word"]
    assert len(conversion.cameras) == len(said["cameras"])
    for camera, other in zip(conversion.cameras, said["cameras"]):
        assert camera.target.model == other["to"]["model"] if "to" in other else True
        assert camera.target.parameters == other["parameters"]
        assert camera.error.rms == pytest.approx(other["error_px"]["rms"], rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("keywords, options", [
    ({"objective": "max"}, ["--objective", "max"]),
    ({"weight": "angle"}, ["--weight", "angle"]),
    ({"fix": {"alpha": 0.6}}, ["--fix", "alpha=0.6"]),
    ({"fix": {"cx": None, "cy": None}}, ["--fix", "cx,cy"]),
    ({"fix": {"fx": "fy"}}, ["--fix", "fx=fy"]),
    ({"absorb_rotation": True}, ["--absorb-rotation"]),
    ({"pair": True}, ["--pair"]),
    ({"every_pixel": True}, ["--every-pixel"]),
    ({"camera": "cam1"}, ["--camera", "cam1"]),
    ({"camera": [1, 0]}, ["--camera", "1,0"]),
    ({"max_error": 1e-9}, ["--max-error", "1e-9"]),
    ({"strict": True}, ["--strict"])])
def test_a_keyword_is_the_option(keywords, options):
    plain = fca_io.convert(CHAIN, "kalibr", model="eucm", max_angle=85.0)
    conversion = fca_io.convert(CHAIN, "kalibr", model="eucm", max_angle=85.0, **keywords)
    same_cameras(conversion, told(CHAIN, "--to", "kalibr", "--model", "eucm", "--max-angle", "85", *options))
    if set(keywords) & {"objective", "weight", "fix", "pair"}:
        assert conversion.cameras[0].target.parameters != plain.cameras[0].target.parameters


def test_a_degree_and_settings():
    low = fca_io.convert(DS, "ocamcalib", degree=4, camera=0)
    high = fca_io.convert(DS, "ocamcalib", degree=8, camera=0)
    assert high.cameras[0].error.rms < low.cameras[0].error.rms
    settings = fca_io.convert(CHAIN, "orbslam3", fps=25, set={"Viewer.PointSize": 3.5}).files["settings.yaml"].decode()
    assert "Viewer.PointSize: 3.5" in settings and "Camera.fps: 25" in settings


def test_an_image_of_weights():
    image = np.zeros((512, 512), np.uint8)
    image[200:312, 200:312] = 255
    def centre_error(conversion):
        [camera] = conversion.cameras
        pixels = np.mgrid[210:300:10, 210:300:10].reshape(2, -1).T.astype(float)
        return np.abs(camera.target.project(camera.source.unproject(pixels)) - pixels).max()
    options = {"model": "ucm", "camera": 0, "max_angle": 85.0}
    weighted = fca_io.convert(CHAIN, "kalibr", weight=image, **options)
    assert centre_error(weighted) < 0.2 * centre_error(fca_io.convert(CHAIN, "kalibr", **options))
    coloured = fca_io.convert(CHAIN, "kalibr", weight=np.repeat(image[:, :, None], 3, axis=2), **options)
    assert coloured.cameras[0].target == weighted.cameras[0].target
    with pytest.raises(fca_io.Error):
        fca_io.convert(CHAIN, "kalibr", weight=image[:100], **options)
    for other in (image[0], np.zeros((512, 512, 2), np.uint8), "centre"):
        with pytest.raises(ValueError):
            fca_io.convert(CHAIN, "kalibr", weight=other, **options)


TILTED = """cam0:
  camera_model: pinhole
  intrinsics: [460.0, 458.0, 367.0, 248.0]
  distortion_model: radtan
  distortion_coeffs: [-0.05, 0.01, 0.002, -0.001]
  resolution: [752, 480]
  rostopic: /cam0/image_raw
  T_cam_imu:
  - [0.0, 1.0, 0.0, 0.02]
  - [-1.0, 0.0, 0.0, 0.01]
  - [0.0, 0.0, 1.0, -0.03]
  - [0.0, 0.0, 0.0, 1.0]
"""


def test_a_turn_is_written_into_the_poses(tmp_path):
    chain = tmp_path / "camchain.yaml"
    chain.write_text(TILTED)
    conversion = fca_io.convert(chain, "kalibr", model="kb4", absorb_rotation=True)
    turned = [camera.turn for camera in conversion.cameras if camera.turn is not None]
    assert turned
    for R in turned:
        np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-12)
        assert 0.0 < np.linalg.norm(R - np.eye(3)) < 0.1
    assert all(camera.turn is None for camera in fca_io.convert(chain, "kalibr", model="kb4").cameras)
    conversion.save(tmp_path / "turned")
    [written] = (tmp_path / "turned").iterdir()
    before, after = (fca_io.read(path).pose("cam0", "imu0")[:3, :3] for path in (chain, written))
    turn = after @ before.T
    np.testing.assert_allclose(turn, turned[0], atol=1e-9)


def test_a_pair_is_what_stereo_feels():
    options = {"model": "eucm", "max_angle": 85.0}
    separate = fca_io.convert(CHAIN, "kalibr", **options)
    said = told(CHAIN, "--to", "kalibr", "--model", "eucm", "--max-angle", "85")["pair"]
    assert separate.pair.rms == pytest.approx(said["epipolar_rms_px"], rel=1e-9)
    assert separate.pair.max == pytest.approx(said["epipolar_max_px"], rel=1e-9)
    assert {separate.pair.first, separate.pair.second} == {"cam0", "cam1"}
    assert fca_io.convert(CHAIN, "kalibr", pair=True, **options).pair.rms < separate.pair.rms
    assert fca_io.convert(CHAIN, "kalibr", camera=0).pair is None


def test_uncertainty_is_carried_to_the_written_camera():
    chain = COVARIANCE.parent / "camchain.yaml"
    options = {"model": "eucm", "max_angle": 80.0}
    [camera] = fca_io.convert(chain, "kalibr", parts=[COVARIANCE], **options).cameras
    [said] = told(chain, "--with", COVARIANCE, "--to", "kalibr", "--model", "eucm", "--max-angle", "80")["cameras"]
    own, expected = camera.uncertainty, said["uncertainty"]
    assert own.correlations_known and pathlib.Path(own.source).name == "covariance.csv"
    assert (own.rms, own.max, own.error_sigmas) == pytest.approx((expected["rms_px"], expected["max_px"], expected["error_sigmas"]))
    assert own.max_at == pytest.approx(expected["max_at"])
    assert own.sigmas == pytest.approx(expected["sigmas"]) and list(own.sigmas) == list(camera.target.parameters)
    np.testing.assert_allclose(own.covariance, np.reshape(expected["covariance"], own.covariance.shape))
    np.testing.assert_allclose(np.sqrt(np.diag(own.covariance)), list(own.sigmas.values()))
    [plain] = fca_io.convert(chain, "kalibr", **options).cameras
    assert plain.uncertainty is None
    assert fca_io.convert(chain, "kalibr", parts=[COVARIANCE], max_error_sigmas=1e-6, **options).verdict == "do-not-use"
    with pytest.raises(fca_io.Error) as caught:
        fca_io.convert(chain, "kalibr", max_error_sigmas=0.5, **options)
    assert caught.value.code == "sigma-unknown"


def test_losses_say_what_and_why():
    losses = fca_io.convert(CHAIN, "kalibr", model="eucm", camera=0).losses + fca_io.convert(CHAIN, "opencv").losses
    said = told(CHAIN, "--to", "opencv")["losses"]
    assert losses and {loss.matters for loss in losses} <= {True, False}
    assert len(fca_io.convert(CHAIN, "opencv").losses) == len(said)
    assert all(loss.what and loss.why for loss in losses)


def test_an_edited_file_keeps_the_rest(tmp_path):
    base = tmp_path / "base.yaml"
    base.write_bytes(fca_io.convert(CHAIN, "orbslam3", set={"Viewer.PointSize": 7.5}).files["settings.yaml"])
    [written] = fca_io.convert(DS, "orbslam3", into=base).files.values()
    assert b"Viewer.PointSize: 7.5" in written
    assert base.read_bytes() != written
    with pytest.raises(ValueError):
        fca_io.convert(DS, "orbslam3", into=base, absorb_rotation=True)


def test_images_that_were_changed(tmp_path):
    camera = fca_io.read(CHAIN).cameras[0]
    half = fca_io.read(CHAIN, resize=(256, 256), camera="cam0")
    assert [each.name for each in half.cameras] == ["cam0"] and half.cameras[0].image_size == (256, 256)
    rays = camera.unproject([[100.0, 200.0], [300.0, 50.0]])
    # Pixel centres: u' + 1/2 = (u + 1/2) / 2.
    np.testing.assert_allclose(half.cameras[0].project(rays), (camera.project(rays) + 0.5) / 2.0 - 0.5, atol=1e-9)
    cropped = fca_io.read(CHAIN, crop=(64, 32, 384, 400)).cameras[0]
    np.testing.assert_allclose(cropped.project(rays), camera.project(rays) - [64.0, 32.0], atol=1e-9)
    assert fca_io.read(CHAIN, binning=2).cameras[0] == half.cameras[0]
    assert fca_io.convert(half, "kalibr").cameras[0].target.image_size == (256, 256)


@pytest.mark.parametrize("words", [{"degree": 99}, {"fix": {"k99": 0.0}}, {"fix": {"cx": "cy"}}, {"objective": "mean"},
                                   {"max_error": -1.0}, {"fps": 0.0}, {"baseline": -1.0}, {"max_angle": 200.0},
                                   {"accept": ["no-such-code"]}, {"objective": "max", "weight": "angle"}])
def test_values_that_cannot_be(words):
    with pytest.raises(ValueError):
        fca_io.convert(CHAIN, "kalibr", **words)


@pytest.mark.parametrize("words", [{"modell": "eucm"}, {"strict": "very"}, {"fix": 3}, {"parts": 3}, {"camera": 1.5}])
def test_other_keywords_and_types(words):
    with pytest.raises(TypeError, match=next(iter(words))):
        fca_io.convert(CHAIN, "kalibr", **words)


def functions_of_stub():
    stub = ast.parse(pathlib.Path(fca_io.__file__).with_suffix(".pyi").read_text())
    return {node.name: [each.arg for each in node.args.kwonlyargs] for node in stub.body if isinstance(node, ast.FunctionDef)}


@pytest.mark.parametrize("name", ["read", "convert", "rectify"])
def test_stub_docstring_and_function_have_the_same_keywords(name):
    function = getattr(fca_io, name)
    words = {"to": "kalibr"} if name == "convert" else {}
    for keyword in functions_of_stub()[name]:
        assert keyword in function.__doc__, keyword
        function(CHAIN, **words, **{keyword: None})
    with pytest.raises(TypeError):
        function(CHAIN, **words, no_such_keyword=None)


def test_help_names_what_people_import():
    for name in fca_io.__all__:
        thing = getattr(fca_io, name)
        assert thing.__module__ == "fca_io", name
        assert "_native" not in (thing.__doc__ or ""), name
        if name[0].islower():
            assert f"    {name}" in fca_io.__doc__, name
        else:
            for attribute, value in vars(thing).items():
                assert attribute.startswith("_") or isinstance(value, (str, type(None))) or value.__doc__, f"{name}.{attribute}"
