# SPDX-License-Identifier: BSD-3-Clause
"""Files of testdata of which the program that runs here makes something else than our reader of it, and why: what it does, and the
version that our reader is of. A test fails when that is no longer so."""

SPLITS = "COLMAP 3.8 splits a line at single blanks; later ones at any"
NEWER_LENS = "its lens is of a newer COLMAP"
NO_SUCH_ID = "the id is COLMAP's word for none: 3.8 reads the camera, and no image can have it"
BEYOND_END = "COLMAP 3.8 reads what is not there and goes on; our reader refuses what it cannot foretell"
REDUCED = "camera_calibration_parsers 1.12.0 reads neither binning nor roi; ROS 2's does since image_common#254"
BOOST_INI = "the .ini parser of 1.12.0 wants [image] first and no comment of ;; ROS 2's is another one"

EXCEPTIONS = {
    ("ros", "binned.yaml"): ("other pixels", REDUCED),
    ("ros", "binning-by-thousand.yaml"): ("other pixels", REDUCED),
    ("ros", "binning-by-text.yaml"): ("loads", REDUCED),
    ("ros", "roi-beyond.yaml"): ("loads", REDUCED),
    ("ros", "roi-without-height.yaml"): ("loads", REDUCED),
    ("ros", "videre.ini"): ("stops", BOOST_INI),
    ("ros", "ini-no-image.ini"): ("stops", BOOST_INI),
    ("colmap", "comment-after.txt"): ("stops", SPLITS),
    ("colmap", "tab.txt"): ("stops", SPLITS),
    ("colmap", "two-blanks.txt"): ("stops", SPLITS),
    ("colmap", "eucm-alpha.txt"): ("stops", NEWER_LENS),
    ("colmap", "newer-lenses.bin"): ("stops", NEWER_LENS),
    ("colmap", "id-negative.txt"): ("stops", NO_SUCH_ID),
    ("colmap", "id-none.txt"): ("stops", NO_SUCH_ID),
    ("colmap", "id-of-32-bits.bin"): ("stops", NO_SUCH_ID),
    ("colmap", "id-twice.txt"): ("loads", "COLMAP 3.8 keeps the first of two cameras with one id; a later one stops"),
    ("colmap", "id-twice.bin"): ("loads", "COLMAP 3.8 keeps the first of two cameras with one id; a later one stops"),
    ("colmap", "not-a-number.txt"): ("loads", "COLMAP 3.8 reads 511 of 511,75; a later one stops"),
    ("colmap", "size-real.txt"): ("loads", "COLMAP 3.8 reads 640 of 640.0; a later one stops"),
    ("colmap", "count-of-three.bin"): ("loads", BEYOND_END),
    ("colmap", "cut-in-id.bin"): ("loads", BEYOND_END),
    ("colmap", "cut-in-parameters.bin"): ("loads", BEYOND_END),
    ("colmap", "width-of-64-bits.bin"): ("loads", "COLMAP holds widths of 64 bits; our reader takes no image of 2^40 columns"),
    ("mrcal", "poses-differ.cameramodel"): ("loads", "mrcal stops since 2.5; 2.2 reads extrinsics alone"),
}
