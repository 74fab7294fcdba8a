// SPDX-License-Identifier: BSD-3-Clause
// What every code means. Kept by name, so that a code is found by eye; a test compares the table with what checks say.
#include <fca/formats/check.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

// What is the same for many codes.
constexpr std::string_view kNotRead = "No program can read the file; fca-io does not, either.";
constexpr std::string_view kProgramStops = "The program stops at once, or goes on without what stands there.";
constexpr std::string_view kWrongPose =
    "Points are carried into the wrong frame: visual-inertial estimation diverges or settles on a wrong scale and direction.";
constexpr std::string_view kWrongPixels = "Every pixel away from the centre gets a wrong direction.";
constexpr std::string_view kWrongWeights = "The filter trusts the IMU too much or too little; the trajectory drifts or jumps.";
constexpr std::string_view kGarbage = "OCamCalib's reader goes on with the wrong numbers and says nothing.";

constexpr std::array kCodes = {
    CheckCode{"a1-not-zero", "OCamCalib's second coefficient is not 0", kWrongPixels,
              R"(OCamCalib fits  f(rho) = a0 + a2 rho^2 + a3 rho^3 + a4 rho^4  with a1 = 0: the surface is flat on the axis.
The file has the coefficients ascending, a1 included, so its second number is 0. Another number there is a list in
MATLAB's descending order, a list without a1, or another program's polynomial.)"},
    CheckCode{
        "ambiguous-format", "more than one format could be meant", "fca-io does not guess.",
        R"(The keys of two formats stand in one file, and the first line of the finding names both with the keys that speak for each.
--from FORMAT decides. Usually one file was pasted into another: take them apart.)"},
    CheckCode{
        "ambiguous-model", "four distortion coefficients, and nothing says of which lens",
        "A program that takes them for the other lens puts rays wrong: at the border of a wide lens by tens of degrees.",
        R"(cv::projectPoints takes four numbers as k1 k2 p1 p2 of a radial-tangential lens, cv::fisheye as k1 k2 k3 k4 of an
equidistant one. An OpenCV file need not say which. The finding shows both readings with the angle that each would see
across the image: the lens's data sheet decides. Then give --opencv-model pinhole or fisheye.)"},
    CheckCode{"baseline-contradicts", "ORB-SLAM's bf is not baseline times fx",
              "Depths of the stereo pair or depth sensor are wrong by that factor.",
              R"(Camera.bf = b fx, with the baseline b in metres and fx of the rectified camera. The same baseline stands in
RIGHT.P(0, 3) = -b fx or in the second camera's pose. Checked to 5 %.)"},
    CheckCode{
        "baseline-is-bf", "ORB-SLAM3's Stereo.b holds bf", "Depths come out fx (hundreds of) times too large.",
        R"(Stereo.b of ORB-SLAM3's new settings is the baseline in metres; Camera.bf of the older ones is  bf = b fx.  Above 5 m,
and with Stereo.b / fx between 0.02 and 2 m, bf is named. Millimetres look alike (47.9 is 0.11 m times 435 px, and 47.9 mm):
then both are shown.)"},
    CheckCode{"bf-is-a-baseline", "ORB-SLAM's bf holds the baseline alone", "Depths come out fx (hundreds of) times too small.",
              "Camera.bf = baseline in metres times Camera.fx in pixels: 0.11 m and 435 px give 47.9."},
    CheckCode{
        "binary-file", "the file is not text", kNotRead,
        R"(A zero byte, or bytes that are no UTF-8 where a value stands. An image, an archive or a file saved as UTF-16: save it
as UTF-8.)",
        "save it as UTF-8 text"},
    CheckCode{
        "blank-missing", "no blank behind a key's colon", kNotRead,
        R"(OpenCV's reader takes key:2, to every other YAML parser it is one word, and what follows is read as something else or
not at all: the parser's own message is about a later line. --fix puts the blank in.)"},
    CheckCode{
        "byte-order-mark", "invisible bytes before the first character", kProgramStops,
        R"(Windows editors begin UTF-8 files with EF BB BF, which no editor shows. cv::FileStorage (OpenCV, ORB-SLAM, OpenVINS) and
Python's json take them for content and stop; PyYAML skips them. --fix takes them away.)"},
    CheckCode{"cannot-read", "the file cannot be read", "No program can read it.",
              "The operating system refuses: the file does not exist, is a folder or may not be read."},
    CheckCode{
        "carla-translation", "SynWoodScape's translation in CARLA's frame",
        "WoodScape's projection.py stops with KeyError: 'translation'.",
        R"(CARLA is left-handed and has another origin; the published files differ in the order of y and z. The pose is left
out rather than guessed.)"},
    CheckCode{
        "centre-off", "the principal point is far from the middle", kWrongPixels,
        R"(Compared are |cx - (w - 1) / 2| with w / 2, and the same downwards; above 0.3 is said. Real lenses are mounted within
0.1. A cropped image, other resolution's numbers and an exchange of numbers look so, and a poor calibration.)"},
    CheckCode{"centre-outside", "the principal point lies outside the image", kWrongPixels,
              "As centre-off, above 1: Kalibr refuses a negative one. Only a crop that leaves out the middle is so."},
    CheckCode{
        "centre-swapped", "OCamCalib's centre has column before row", kWrongPixels,
        R"(calib_results.txt has the centre as row, column and the size as height, width. MATLAB's DistortionCenter is column,
row. The other order is said if it puts the centre at most half as far from the middle, and as it stands it is more than 0.03
diagonals of the image from there; on an image that is almost square nobody can tell.)"},
    CheckCode{
        "comment-lines", "a line too many before a block", kGarbage,
        R"(get_ocam_model reads calib_results.txt by lines: one line skipped, one block read, five times over. With two comment
lines before a block it takes the second for the numbers. Blank lines count, too.)"},
    CheckCode{"comment-missing", "no comment line before a block", kGarbage,
              "get_ocam_model skips exactly one line before each of its five blocks, whatever stands there."},
    CheckCode{
        "comment-too-long", "a comment line longer than the reader's buffer", kGarbage,
        "get_ocam_model skips a comment with fgets into a buffer of 1024 bytes; the rest of a longer line is read as numbers."},
    CheckCode{"degree-too-high", "a polynomial of a higher degree than fca-io holds",
              "fca-io does not read the file; OCamCalib may.",
              "MATLAB's default is degree 4; the message says up to which degree fca-io holds the polynomial.",
              "calibrate with a lower degree"},
    CheckCode{
        "depth-threshold", "ThDepth is not in baselines",
        "Nearly all stereo points count as close, or nearly all as far, and their depths are weighted so.",
        R"(ORB-SLAM takes points nearer than ThDepth * baseline for close, whose depth one view gives. 35 to 60 in upstream's
examples; 0.1 and 2000 are metres or millimetres. With 0 or less no point counts as close.)"},
    CheckCode{
        "distortion-missing", "no distortion coefficients beside a camera matrix", kWrongPixels,
        R"(Without coefficients OpenCV's functions take a lens without distortion. If the images are rectified that is right; if
not, D, distortion_coefficients or D1 belong beside the matrix.)",
        "if the images are not rectified, copy the coefficients beside the matrix"},
    CheckCode{
        "duplicate-key", "a key stands twice", "Kalibr takes the last one, OpenCV and ORB-SLAM3 the first.",
        R"(PyYAML keeps the last of two equal keys, yaml-cpp and cv::FileStorage the first, and none says so. Two programs thus read
two calibrations out of one file. Delete the one that is not meant.)",
        "delete one of the two"},
    CheckCode{"empty-file", "the file is empty", kNotRead,
              "Nothing but blanks. A program that died while it wrote, or a full disk, leaves such files.",
              "write or copy the file once more"},
    CheckCode{
        "eucm-without-type", "EUCM's alpha and beta under ORB-SLAM2's k1 and k2",
        "ORB-SLAM2 takes them for radial distortion: every pixel is wrong.",
        R"(ns15417/slam_no_opt reads EUCM's alpha and beta from Camera.k1 and Camera.k2 when Camera.type says so. Without it they are
radial distortion: alpha of 0.6 and beta of 1.1 as k1 and k2 bend the image beyond recognition.)"},
    CheckCode{
        "file-version-missing", "ORB-SLAM3 V1.0's keys without File.version", kProgramStops,
        R"(ORB-SLAM3 V1.0 takes its new keys (Camera1.fx) only where File.version is the string "1.0"; without it, it looks for
Camera.fx and stops.)"},
    CheckCode{
        "file-version-not-string", "File.version is not the string \"1.0\"",
        "ORB-SLAM3 silently runs its old parser and finds no camera.",
        R"(ORB-SLAM3 compares the string: File.version: "1.0". A bare 1.0 is a number to cv::FileStorage and compares unequal.)"},
    CheckCode{
        "focal-length-not-in-pixels", "the focal length does not belong to the image", kWrongPixels,
        R"(A focal length below 0.05 of the width would see more than 1100 deg across an equidistant image; above 20 times the
width, less than 3 deg. Millimetres (4.2) and normalised numbers (0.83) look like the first, a missing decimal point like
the second.)"},
    CheckCode{"focal-lengths-differ", "fx and fy are not alike", "If one is wrong, directions are stretched along one axis.",
              "Pixels are square on nearly every sensor of the last twenty years: above 5 % is said. Anamorphic images are "
              "right so."},
    CheckCode{"folds-inside-image", "the lens model ends inside the image",
              "Pixels beyond have no ray; a ray beyond lands on a pixel that belongs to another one.",
              R"(A polynomial that fits the calibrated part of the image may turn round beyond it:

  radius |        ___
         |     .-'   '-.      <- from here on two rays share a pixel
         |   .'
         |  /
         +---------------- angle from the axis

The angle is where the radius stops growing; the pixels are those of the image beyond that radius. Within 85 deg a warning:
such a lens fills the image. Beyond, a note: a fisheye's image circle may end there. If it is within half the way to the
border, an error. --max-angle says what counts as lens.)"},
    CheckCode{"image-size-invalid", "an image cannot have that size", kNotRead,
              "Width and height are whole numbers of pixels, at least 1, and what a camera can have at most: a digit too many "
              "or too few.",
              "write the width and height of the images in pixels"},
    CheckCode{
        "imu-noise-too-large", "IMU noise above any sensor's", kWrongWeights,
        R"(Asked for is the continuous-time density sigma_c. A discrete deviation at rate f is  sigma_d = sigma_c sqrt(f): at
200 Hz 14 times larger. In degrees a gyroscope's is 57 times larger. People multiply the data sheet's by 5 to 20 for SLAM,
which is allowed for: above 2e-2 rad/s/sqrt(Hz) or 0.2 m/s^2/sqrt(Hz) is said. Down to a twentieth of that, where a
deviation and a density that was made larger look alike, it is called not decidable.)"},
    CheckCode{
        "imu-noise-too-small", "IMU noise below any sensor's", kWrongWeights,
        "A variance is the density squared: (1.7e-4)^2 = 2.9e-8. Below 2e-6 rad/s/sqrt(Hz) or 2e-5 m/s^2/sqrt(Hz) is said."},
    CheckCode{"imu-rate", "a rate no IMU has", kWrongWeights,
              "IMUs of cameras run at 100 to 1000 Hz; below 20 and above 10000 Hz is said. 0.2 is kilohertz, 0.005 the step in "
              "seconds."},
    CheckCode{"imu-sensors-swapped", "gyroscope noise above the accelerometer's", kWrongWeights,
              "In SI units a MEMS gyroscope has about 1e-4 and its accelerometer 1e-3."},
    CheckCode{
        "imu-walk-above-noise", "a gyroscope's random walk above its noise", kWrongWeights,
        "Their units differ (rad/s^2/sqrt(Hz) and rad/s/sqrt(Hz)); the numbers of real gyroscopes differ by 10 and more."},
    CheckCode{
        "int-for-real", "a whole number where the program wants a real one", kProgramStops,
        R"(Kalibr asks Python for a float, ORB-SLAM3 cv::FileNode for REAL: 190 and 20 are ints to both and refused. A decimal
point mends it.)"},
    CheckCode{
        "inverse-missing", "no inverse polynomial", "OCamCalib's world2cam cannot project.",
        R"(calib_results.txt holds two polynomials: pixel to ray (the calibrated one) and ray to pixel (a fit to it). MATLAB's toolbox
leaves the second out unless find_and_export_data was run. fca-io convert FILE --to ocamcalib computes it.)"},
    CheckCode{"json-syntax", "not JSON", kNotRead,
              "RFC 8259: double quotes, no comments, no comma behind the last item, no NaN. Python writes NaN and reads it; "
              "others do not.",
              "write numbers as numbers and names in double quotes, without a comma behind the last one"},
    CheckCode{"key-assumed", "a key is missing that the program has a value for", "The program goes on with its own value.",
              "The message says which. Whether that is what was meant nothing in the file tells.", "state it"},
    CheckCode{
        "key-misspelt", "a key that nobody reads, beside one that is missing",
        "What it states is not known to the program, which stops or takes a default.",
        R"(A key differs from one that the format has, and that is not there, by a letter: lost, too many, wrong, in the other
case, or exchanged with its neighbour. Digits are no letters. Or a block holds a camera and is not called cam0, cam1, ...)",
        "spell it as the format does, or delete it"},
    CheckCode{"left-handed", "a pose that mirrors", kWrongPose,
              "det R = -1. No motion turns a camera into its mirror image: a sign is wrong, or two rows are exchanged."},
    CheckCode{"matlab-origin", "MATLAB counts pixels from 1", "The principal point is one pixel off.",
              "In MATLAB the centre of the first pixel is (1, 1), in OpenCV (0, 0): subtract 1 from cx and cy."},
    CheckCode{"matrix-corner", "K(2, 2) is not 1", "inv(K) and K * p come out wrong in programs that compute them.",
              "A camera matrix is [fx s cx; 0 fy cy; 0 0 1]. MATLAB's is its transpose; projection matrices have three rows of "
              "four."},
    CheckCode{"matrix-not-float", "a matrix of doubles where ORB-SLAM3 reads floats",
              "ORB-SLAM3 takes the first half of the bytes for its numbers: the pose is garbage, and nothing says so.",
              "Stereo.T_c1_c2, IMU.T_b_c1, Tbc and Tlr are read by .at<float>(); dt: d stores eight bytes per number."},
    CheckCode{
        "matrix-transposed", "a camera matrix with its columns as rows", kWrongPixels,
        R"(MATLAB writes K' = [fx 0 0; s fy 0; cx cy 1] where OpenCV has [fx s cx; 0 fy cy; 0 0 1]. cx and cy then stand in the last
row, and a program that reads K(0, 2) finds 0.)"},
    CheckCode{
        "matrix-type", "a matrix type that does not suit", kWrongPixels,
        R"(dt of an !!opencv-matrix: d (double) or f (float), one channel. Integers (i, u) cut the decimals off; 2d has two numbers
per place.)",
        "write dt: d and the numbers with their decimals"},
    CheckCode{"merge-conflict", "git's merge-conflict markers", kNotRead,
              "<<<<<<<, ======= and >>>>>>> enclose two versions that git could not merge. Choose one and delete the markers."},
    CheckCode{
        "missing-block", "the file ends too early", kGarbage,
        R"(calib_results.txt has five blocks: direct polynomial, inverse polynomial, centre, affine c d e, image size. A reader that
finds fewer keeps whatever was in its memory.)",
        "copy the file once more from where the calibration wrote it"},
    CheckCode{"missing-key", "a key is missing", kProgramStops,
              "The message names the key and the program that stops without it.",
              "add it from the calibration's own output; no default is right for a camera"},
    CheckCode{
        "mode-refused", "ORB-SLAM3 starts, but not in the mode the keys are for",
        "Started in that mode ORB-SLAM3 exits; started in another, the keys are not used.",
        R"(A settings file has the keys of one mode: Camera2 and Stereo.* for stereo, RGBD.* for depth, IMU.* for inertial. The message
names the first key that is missing or mistyped for the richest mode that its keys speak for.)",
        "add what the message names, or take out the keys of that mode"},
    CheckCode{
        "model-contradicts", "told to be read as another lens than the file says", kWrongPixels,
        R"(--opencv-model says one lens and the file's own metadata (fisheye_model, distortion_type, xi) the other. One of the two is
not meant.)",
        "leave --opencv-model out, or correct the file's own words"},
    CheckCode{"name-unprintable", "a name that cannot be printed",
              "Terminals obey control characters; logs and file names break at line breaks.",
              "The name of a camera or topic holds line breaks, control characters or bytes that are not UTF-8.",
              "give it a name of printable characters"},
    CheckCode{"no-calibration", "neither a camera nor an IMU's noise", "There is nothing in it to use.",
              "The syntax is right and some keys are known; but no camera stands there, and no IMU with noise densities.",
              "give the file that the calibration wrote"},
    CheckCode{
        "not-a-camera", "a parameter no camera has", kWrongPixels,
        R"(The ranges: focal lengths > 0, alpha in [0, 1], beta > 0, xi of Double Sphere in [-1, 1]. Kalibr's lists begin with
[alpha beta ..] for eucm, [xi alpha ..] for ds, [xi ..] for omni: exchanged, alpha leaves its range.)",
        "compare the list with the calibration's report: is a number missing, doubled or of another model?"},
    CheckCode{"not-a-camera-matrix", "no camera matrix", kWrongPixels, "3 x 3, [fx s cx; 0 fy cy; 0 0 1], fx and fy above 0.",
              "write [fx 0 cx; 0 fy cy; 0 0 1]"},
    CheckCode{"not-a-list", "a list is wanted", kProgramStops,
              "The message names what the program asks for there. A list is [1.0, 2.0], or a line with a dash for each item.",
              "write its numbers in brackets, with commas between them"},
    CheckCode{"not-a-mapping", "keys and values are wanted", kProgramStops,
              "Keys with values are wanted: `key: value`, with a blank behind the colon.", "write its keys below it, indented"},
    CheckCode{"not-a-matrix", "an opencv-matrix is wanted", kProgramStops,
              "K: !!opencv-matrix with rows, cols, dt and data below it; cv::FileStorage makes a matrix of nothing else.",
              "write it as !!opencv-matrix with rows, cols, dt and data"},
    CheckCode{"not-a-number", "a number is wanted", kProgramStops,
              "Decimal comma, unit (190 px), letter O, typographic minus: none is part of a number. 190.97 and 1.9e+02 are.",
              "write a number there, with a decimal point and not in words"},
    CheckCode{
        "not-a-rotation", "the 3 x 3 part of a pose is not a rotation",
        "Distances and directions are sheared; Sophus (in ORB-SLAM3's old parser) aborts.",
        R"(R^T R = I for a rotation. Printed with three digits it is off by 2e-3 at most, with two by 2e-2: above the first is a
warning, above the second an error. The nearest rotation is the orthogonal factor of the polar decomposition R = Q S.
A quaternion must have length 1.)",
        "copy it from the calibration's result"},
    CheckCode{"not-a-string", "a name is wanted", kProgramStops,
              R"(A number or a list stands where a name is read. Quotes make text of what looks like a number: "1.0".)",
              "write a name there, without brackets"},
    CheckCode{"not-a-transform", "the last row of a pose is not 0 0 0 1", kWrongPose,
              "If the last column is 0 0 0 1, the matrix is transposed.",
              "write 0 0 0 1 there; if the last column is 0 0 0 1, transpose the matrix"},
    CheckCode{"not-an-integer", "a whole number is wanted", kProgramStops, "A count of pixels or frames per second is wanted.",
              "write a whole number"},
    CheckCode{"not-finite", "not a finite number", kProgramStops,
              "NaN and infinity are what a calibration leaves that did not converge.", "calibrate again"},
    CheckCode{"not-in-pixels", "WoodScape's k1 is not in pixels", kWrongPixels,
              "rho = k1 theta + ... in pixels: k1 is 200 to 600. Normalised Kannala-Brandt coefficients (0.18) stand there in "
              "forks."},
    CheckCode{"not-positive", "a number above 0 is wanted", kProgramStops,
              "Focal lengths, image sizes, rates and noise densities are above 0.",
              "write the camera's or sensor's own number"},
    CheckCode{"not-settings", "no keys at the top level", kNotRead,
              "ORB-SLAM's settings are `Camera.fx: 458.6`, one key below the other at the left margin.",
              "write the keys at the left margin, one a line"},
    CheckCode{
        "number-as-text", "a number the program reads as text", kProgramStops,
        R"(PyYAML (Kalibr) takes a number for a real one only with a point, and with a sign in the exponent: 1.0e-05. 1e-5 and 1e5
are text to it.)"},
    CheckCode{"octal", "a number with a leading 0", "The programs read 017 as fifteen.",
              "cv::FileStorage and PyYAML take a leading 0 for base 8, as C does: 017 is 15, and 09 is none.",
              "write the number without its leading 0"},
    CheckCode{
        "opencv-header", "OpenCV's first line in a file for YAML",
        "Kalibr stops at the first line; OpenVINS, which reads with OpenCV, does not.",
        R"(%YAML:1.0 is no YAML: the directive is %YAML 1.2 with a blank. One layout is read by PyYAML, yaml-cpp and OpenCV
alike: first line %YAML 1.2, second line ---, lists indented deeper than their key, every real number with a point.)"},
    CheckCode{
        "out-of-range", "a number beyond any camera's or rig's", kWrongPose,
        R"(fca-io's limits are far beyond any camera's: they keep arithmetic from overflowing. A number like 1e300 is a digit too many
or uninitialised memory.)",
        "compare it with the calibration's result: a digit too many?"},
    CheckCode{
        "part-missing", "a file that it names as its part is missing",
        "VINS-Fusion goes on without that camera and crashes at its first image.",
        R"(VINS-Fusion's configuration names its camera files (cam0_calib, cam1_calib), relative to its own folder. Each is
looked for there and checked as a file of its own.)"},
    CheckCode{
        "polynomial-sign", "OCamCalib's a0 is positive", kWrongPixels,
        "OCamCalib's camera looks along -z: f(0) = a0 < 0, some -200 to -2000 px. A positive one is another toolbox's sign."},
    CheckCode{"pose-implausible", "a camera below the ground", kWrongPose,
              "WoodScape's frame stands on the ground: x ahead, y left, z up. Cameras of a car are 0.4 to 1.5 m above it."},
    CheckCode{
        "pose-inverted", "a pose in the other direction", kWrongPose,
        R"(T_a_b takes points in b to points in a. Kalibr: T_cam_imu (imu -> cam), T_cn_cnm1 (previous camera -> this one).
ORB-SLAM3: IMU.T_b_c1 and Tbc (cam -> imu), Stereo.T_c1_c2 and Tlr (second -> first). WoodScape: camera -> vehicle.
A pose and its inverse are equally long, so that a single one tells nothing; it is decided by the other poses of a loop,
or by the height above a vehicle's ground.)"},
    CheckCode{"pose-missing", "a second camera without a pose", "Stereo modes stop.",
              "Two cameras, and no pose leads from one to the other (T_cn_cnm1, R and T, Stereo.T_c1_c2).",
              "add the pose from the stereo calibration's result"},
    CheckCode{
        "pose-transposed", "a pose with its rotation transposed", kWrongPose,
        R"(R' is the inverse of R: the rotation goes the other way, and the translation, stated for the first, no longer fits.
MATLAB multiplies rows (p' R), Eigen stores columns: either way rows become columns on the way into a file.)"},
    CheckCode{
        "poses-contradict", "two statements of one pose differ",
        "Programs that read the one and those that read the other disagree.",
        R"(T_cam1_imu = T_cam1_cam0 T_cam0_imu. Programs print them from one estimate, to 1e-15; edited files break the loop. Above
0.06 deg or 1 mm a warning, above 1 deg or 1 cm an error. A pose whose inverse, transpose or millimetres would close the
loop is named as such.)"},
    CheckCode{
        "program-finds-no-camera", "no key that a program of OpenCV's samples reads",
        "Programs written after OpenCV's samples find nothing; the program that wrote the file may.",
        R"(OpenCV prescribes no keys: every program looks for its own. Known are camera_matrix (the calibration sample), M1 and K1
(stereo_calib), camera_matrix_left, camera_0.)"},
    CheckCode{"program-ignores", "something no program reads", "It has no effect.",
              "The key is right for another version or program. Harmless, unless you rely on it.",
              "leave it out, or find the place where the program looks for it"},
    CheckCode{"program-misreads", "the program loads the file and does not use all of it as it stands",
              "Part of what the file says has no effect, or another one.",
              "The program loads the file and then uses a part of it otherwise than it is meant, or not at all; the message "
              "says which. In pixels: fca-io show FILE --for PROGRAM.",
              "see what it costs in pixels, with  fca-io show FILE --for PROGRAM,  and change what the message names if that "
              "is too much"},
    CheckCode{"program-other-format", "the program reads another format",
              "It does not start, or takes the file for something else.",
              "Every program reads one format. The command below the finding writes it."},
    CheckCode{
        "program-refuses", "the program refuses the file", kProgramStops,
        R"(The file was given to the program's reader, rebuilt from its source: the message says what it stumbles over. Where another
spelling of the same value would do, --fix makes it.)",
        "give the program what the message says it wants"},
    CheckCode{"real-for-int", "a real number where the program wants a whole one", kProgramStops,
              "Kalibr's resolution, ORB-SLAM3's Camera.fps and sizes are ints: 30.0 is refused."},
    CheckCode{
        "relative-by-centre", "a centre below 1 is taken as relative", kWrongPixels,
        R"(DSO's camera.txt: centre and focal length below 1 are parts of the width and height, and half a pixel is subtracted. A
centre of 0.5 px cannot be told from that.)",
        "write all four numbers in pixels, or all four as shares of the width and height"},
    CheckCode{"size-contradicts", "another image size was told than the file states", kWrongPixels,
              "--size tells what a file does not say. This one says otherwise."},
    CheckCode{
        "size-swapped", "width and height are exchanged", kWrongPixels,
        R"(The principal point is within a tenth of the middle of the image turned by 90 deg, and a fifth away from the middle of
the one stated.)"},
    CheckCode{
        "size-unlike-centre", "the image size is not the one of the calibration", kWrongPixels,
        R"(cx / (w / 2) and cy / (h / 2) are alike, and 30 % and more from 1: the intrinsics are those of another resolution.
Scaled by s they become  f' = s f,  c' = s (c + 0.5) - 0.5.)"},
    CheckCode{
        "skew", "a skew, which fca-io's models do not hold",
        "Nothing, in a program that uses it (cv::omnidir); others ignore it.",
        R"(K(0, 1): pixels whose rows and columns are not at right angles. Calibrated skews are noise; the models of the other formats
have no place for one.)"},
    CheckCode{"stale-inverse", "OCamCalib's two polynomials are of different lenses",
              "Programs that project (world2cam) and those that unproject (cam2world) disagree by that many pixels.",
              "The inverse polynomial is a fit to the direct one, to 0.01 px when fresh. Above 1 px is said."},
    CheckCode{
        "stereo-order", "the second camera stands left of the first",
        "ORB-SLAM3 looks for disparities to one side only and finds no depth.",
        "T_c1_c2 takes points of camera 2 to camera 1: its translation is where camera 2 stands, x > 0 for the right one."},
    CheckCode{
        "thin-prism", "thin-prism terms, which fca-io's models do not hold",
        "Programs other than OpenCV leave these terms out.",
        R"(s1 to s4, OpenCV's coefficients 9 to 12. Without them the pixels move by some 0.1 px at the border: calibrate again without
CALIB_THIN_PRISM_MODEL.)"},
    CheckCode{
        "tilted-sensor", "a tilted sensor, which fca-io's models do not hold",
        "Programs other than OpenCV leave these terms out.",
        R"(tau_x and tau_y, OpenCV's coefficients 13 and 14, for Scheimpflug lenses. No other format has them: calibrate again without
CALIB_TILTED_MODEL.)"},
    CheckCode{
        "time-offset-large", "a time offset longer than a frame",
        "The estimator starts with images of another moment; many refuse to correct that much.",
        R"(t_imu = t_cam + timeshift_cam_imu, in seconds. At 20 Hz a frame takes 0.05 s: more than that pairs images with the motion of
another one. Milliseconds (5.3) look so, and clocks that were never set.)"},
    CheckCode{"too-deep", "nested too deep", "fca-io does not read the file; programs may end with a full stack.",
              "More than 64 lists within lists. A calibration has three.", "take the brackets away that are too many"},
    CheckCode{"too-large", "larger than any calibration", "fca-io does not read the file; programs may, in seconds.",
              "More than 2 MiB. The largest calibration seen has 193 kB; images and point lists make the rest.",
              "take images and point lists out of the file"},
    CheckCode{"too-long", "a list longer than any calibration's", "fca-io does not read the file; programs may, in seconds.",
              "The limit is 100,000 values in one list, keys in one block, or lines.", "take out what is no calibration"},
    CheckCode{"too-many-cameras", "more cameras than any rig has", "fca-io does not read the file.",
              "The limit is 100 cameras: their poses are compared each with each.", "split the file"},
    CheckCode{
        "translation-in-mm", "a translation that is not in metres", kWrongPose,
        R"(Kalibr, ORB-SLAM3 and WoodScape state metres. Parts of a rig more than 5 m apart are a warning, 50 m an error: 110 mm
read as metres are 110 m. OpenCV's stereo calibration has the unit of the board.)"},
    CheckCode{"undistortion-inexact", "cv::undistortPoints does not arrive at the ray",
              "Undistorted points near the corners are wrong: in OpenCV, and in ORB-SLAM, VINS and OpenVINS, which call it.",
              R"(cv::undistortPoints inverts the lens by

  x <- (x0 - tangential(x)) / radial(x)

and stops after five steps without looking at what is left. The steeper the distortion the slower it is, and where the
radius of the image hardly grows with the angle it walks away. Told is how far the lens images the found ray from the pixel
that was asked for; above 1 px is said. cv::undistort and remapping are not concerned: they go from ray to pixel.)"},
    CheckCode{
        "units-not-stated", "a translation whose unit no file states", kWrongPose,
        R"(OpenCV's stereo calibration gives T in the unit of the board's squares: metres, centimetres or millimetres. Compare its
length with the distance of the two lenses.)"},
    CheckCode{"unknown-format", "no format fca-io reads", "fca-io cannot tell what it says.",
              "fca-io formats lists what is read, and by which keys it is told.",
              "fca-io formats lists what is read; --from FORMAT forces one"},
    CheckCode{"unknown-model", "a camera model the program does not know", kProgramStops,
              "The message names those that the program knows. fca-io models has the other names of each.",
              "write the program's own name; `fca-io models` has what each is called elsewhere"},
    CheckCode{"unquoted-text", "text without quotes", kProgramStops,
              "File.version: 1.0 is a number to OpenCV; PinHole # a comment is text with its comment. Quotes mend both."},
    CheckCode{"wrong-count", "more or fewer numbers than announced", kGarbage,
              "The first number of OCamCalib's polynomials is how many follow; rows x cols of a matrix is how many numbers "
              "data holds.",
              "write as many numbers as are announced, or announce as many as stand there"},
    CheckCode{"wrong-family", "another lens model's numbers", kWrongPixels,
              R"(Four numbers look alike in every file. What tells them apart:
* radtan's p1 and p2 are below 0.01 on real lenses; k3 and k4 of an equidistant model often are not.
* no lens without distortion sees 100 deg across the image; an equidistant model's k1 near 0 under radtan claims one.
* an equidistant model with |k1| > 0.15 has higher terms of its size; radtan's -0.28 0.07 0.0002 -0.00002 under its name
  ends in next to nothing.
Not decidable: small numbers of a narrow lens, where both readings see the same.)"},
    CheckCode{"wrong-length", "a list of the wrong length", kProgramStops,
              "The message says how many numbers the model has, and in which order.",
              "is a number lost, or the model's name another's?"},
    CheckCode{"wrong-syntax", "not written as the format is", kNotRead, "The message says what is expected in that line.",
              "write the line as the message says"},
    CheckCode{"xml-declaration", "a document type, entity or CDATA section in XML", kNotRead,
              "OpenCV's files have none. An entity can pull in other files or grow to gigabytes: it is not followed."},
    CheckCode{"xml-mixed", "text between elements", kNotRead, "OpenCV's XML has either text or elements in an element.",
              "leave either the text or the elements there"},
    CheckCode{"xml-place", "an XML element out of place", kNotRead,
              "Items of a list are <_>; elsewhere an element's name is its key.",
              "use <_> for the items of a list and names elsewhere"},
    CheckCode{"xml-root", "not OpenCV's XML", kNotRead, R"(cv::FileStorage wants <?xml version="1.0"?> and <opencv_storage>.)",
              "put <opencv_storage> around all other elements"},
    CheckCode{
        "xml-syntax", "not XML", kNotRead,
        "An unclosed element or a missing quote; the place is where the reader gave up, the cause is often a line before.",
        "close every element by its own name"},
    CheckCode{"yaml-alias", "a YAML alias", "fca-io and OpenCV do not read the file; Kalibr does.",
              "*name stands for another part of the file. PyYAML follows it, cv::FileStorage does not; write the values out."},
    CheckCode{"yaml-anchor", "a YAML anchor", "fca-io and OpenCV do not read the file; Kalibr does.",
              "&name marks a part for reuse. PyYAML follows it, cv::FileStorage does not; write the values out."},
    CheckCode{"yaml-documents", "more than one YAML document", "OpenCV reads the first document, Kalibr stops.",
              "A second --- begins a second document: programs read the first, or stop. Make two files of it.",
              "keep one document a file"},
    CheckCode{"yaml-key", "a YAML key that is no text", kNotRead,
              "A list or map as a key, which no calibration has: usually a bracket or dash out of place.",
              "write a name before the colon"},
    CheckCode{
        "yaml-layout", "YAML laid out as OpenCV's reader does not take it", kProgramStops,
        R"(cv::FileStorage (OpenCV, ORB-SLAM, OpenVINS) wants a first line %YAML and lists indented deeper than their key; what
Kalibr writes has neither. This is read by PyYAML, yaml-cpp and OpenCV alike:

  %YAML 1.2
  ---
  cam0:
    T_cam_imu:
      - [0.1, 0.2, 0.3, 0.4]

--fix adds the line and the blanks, and changes no number.)"},
    CheckCode{
        "yaml-syntax", "not YAML", kNotRead,
        R"(The place is where the reader gave up; the cause is often the line before: an open bracket or quote, a missing colon, an
indentation that fits no key above it.)",
        "look for an open bracket or quote there and in the line before"},
    CheckCode{"yaml-tab", "a TAB as indentation", kNotRead,
              "YAML indents with blanks only; OpenCV and PyYAML both refuse TABs there."},
};

}  // namespace

std::span<const CheckCode> check_codes() { return kCodes; }

const CheckCode* find_check_code(std::string_view code) {
  const auto found = std::ranges::lower_bound(kCodes, code, {}, &CheckCode::code);
  return found == kCodes.end() || found->code != code ? nullptr : &*found;
}

}  // namespace fca
