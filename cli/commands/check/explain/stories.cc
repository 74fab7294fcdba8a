// SPDX-License-Identifier: BSD-3-Clause
// Kept by name, so that a story is found by eye; a test compares the table with the codes.
#include "stories.h"

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

constexpr std::array kStories = {
    Story{"a1-not-zero",
          R"(OCamCalib fits  f(rho) = a0 + a2 rho^2 + a3 rho^3 + a4 rho^4  with a1 = 0: the surface is flat on the axis.
The file has the coefficients ascending, a1 included, so its second number is 0. Another number there is a list in
MATLAB's descending order, a list without a1, or another program's polynomial.)"},
    Story{
        "ambiguous-format",
        R"(The keys of two formats stand in one file, and the first line of the finding names both with the keys that speak for each.
--from FORMAT decides. Usually one file was pasted into another: take them apart.)"},
    Story{"ambiguous-model",
          R"(cv::projectPoints takes four numbers as k1 k2 p1 p2 of a radial-tangential lens, cv::fisheye as k1 k2 k3 k4 of an
equidistant one. An OpenCV file need not say which. The finding shows both readings with the angle that each would see
across the image: the lens's data sheet decides. Then give --opencv-model pinhole or fisheye.)"},
    Story{"baseline-contradicts",
          R"(Camera.bf = b fx, with the baseline b in metres and fx of the rectified camera. The same baseline stands in
RIGHT.P(0, 3) = -b fx or in the second camera's pose. Checked to 5 %.)"},
    Story{
        "baseline-is-bf",
        R"(Stereo.b of ORB-SLAM3's new settings is the baseline in metres; Camera.bf of the older ones is  bf = b fx.  Above 5 m,
and with Stereo.b / fx between 0.02 and 2 m, bf is named. Millimetres look alike (47.9 is 0.11 m times 435 px, and 47.9 mm):
then both are shown.)"},
    Story{"bf-is-a-baseline",
          "Camera.bf, or focal_x_baseline, is the baseline in metres times fx in pixels: 0.11 m and 435 px give 47.9."},
    Story{
        "binary-file",
        R"(A zero byte, or bytes that are no UTF-8 where a value stands. An image, an archive or a file saved as UTF-16: save it
as UTF-8.)"},
    Story{
        "blank-missing",
        R"(OpenCV's reader takes key:2, to every other YAML parser it is one word, and what follows is read as something else or
not at all: the parser's own message is about a later line. --fix puts the blank in.)"},
    Story{
        "byte-order-mark",
        R"(Windows editors begin UTF-8 files with EF BB BF, which no editor shows. cv::FileStorage (OpenCV, ORB-SLAM, OpenVINS) and
Python's json take them for content and stop; PyYAML skips them. --fix takes them away.)"},
    Story{"cannot-read", "The operating system refuses: the file does not exist, is a folder or may not be read."},
    Story{"carla-translation",
          R"(CARLA is left-handed and has another origin; the published files differ in the order of y and z. The pose is left
out rather than guessed.)"},
    Story{
        "centre-off",
        R"(Compared are |cx - (w - 1) / 2| with w / 2, and the same downwards; above 0.3 is reported. Real lenses are mounted within
0.1. A cropped image, other resolution's numbers and an exchange of numbers look so, and a poor calibration.)"},
    Story{"centre-outside",
          "As centre-off, above 1: Kalibr refuses a negative one. Only a crop that leaves out the middle is so."},
    Story{"centre-swapped",
          R"(calib_results.txt has the centre as row, column and the size as height, width. MATLAB's DistortionCenter is column,
row. The other order is reported if it puts the centre at most half as far from the middle, and as it stands it is more than 0.03
diagonals of the image from there; on an image that is almost square nobody can tell.)"},
    Story{
        "coefficient-repeated",
        R"(Two of k1 ... k6, p1, p2 agree in five digits and more, to the last. Estimated numbers never do: one was copied to the
other's place.)"},
    Story{
        "comment-lines",
        R"(get_ocam_model reads calib_results.txt by lines: one line skipped, one block read, five times over. With two comment
lines before a block it takes the second for the numbers. Blank lines count, too.)"},
    Story{"comment-missing", "get_ocam_model skips exactly one line before each of its five blocks, whatever stands there."},
    Story{
        "comment-too-long",
        "get_ocam_model skips a comment with fgets into a buffer of 1024 bytes; the rest of a longer line is read as numbers."},
    Story{"cr-line-ends",
          "Old Macs ended lines in CR alone. OpenCV's reader and OCamCalib's look for LF and see one line; PyYAML (Kalibr) "
          "does not."},
    Story{"degree-too-high", "MATLAB's default is degree 4; the message says up to which degree fca-io holds the polynomial."},
    Story{"depth-threshold",
          R"(ORB-SLAM takes points nearer than ThDepth * baseline for close, whose depth one view gives. 35 to 60 in upstream's
examples; 0.1 and 2000 are metres or millimetres. With 0 or less no point counts as close.)"},
    Story{
        "distortion-missing",
        R"(Without coefficients OpenCV's functions take a lens without distortion. If the images are rectified that is right; if
not, D, distortion_coefficients or D1 belong next to the matrix.)"},
    Story{
        "duplicate-key",
        R"(PyYAML keeps the last of two equal keys, yaml-cpp and cv::FileStorage the first, and none says so. Two programs thus read
two calibrations out of one file. Delete the one that is not meant.)"},
    Story{"empty-file", "Nothing but blanks. A program that died while it wrote, or a full disk, leaves such files."},
    Story{
        "eucm-without-type",
        R"(ns15417/slam_no_opt reads EUCM's alpha and beta from Camera.k1 and Camera.k2 when Camera.type says so. Without it they are
radial distortion: alpha of 0.6 and beta of 1.1 as k1 and k2 bend the image beyond recognition.)"},
    Story{
        "file-version-missing",
        R"(ORB-SLAM3 V1.0 takes its new keys (Camera1.fx) only where File.version is the string "1.0"; without it, it looks for
Camera.fx and stops.)"},
    Story{
        "file-version-not-string",
        R"(ORB-SLAM3 compares the string: File.version: "1.0". A bare 1.0 is a number to cv::FileStorage and compares unequal.)"},
    Story{"focal-length-not-in-pixels",
          R"(A focal length below 0.05 of the width would see more than 1100 deg across an equidistant image; above 20 times the
width, less than 3 deg. Millimetres (4.2) and normalised numbers (0.83) look like the first, a missing decimal point like
the second.)"},
    Story{
        "focal-lengths-differ",
        "Pixels are square on nearly every sensor of the last twenty years: above 5 % is reported. Anamorphic images are right "
        "so."},
    Story{"folds-inside-image", R"(A polynomial that fits the calibrated part of the image may turn round beyond it:

  radius |        ___
         |     .-'   '-.      <- from here on two rays share a pixel
         |   .'
         |  /
         +---------------- angle from the axis

The angle is where the radius stops growing; the pixels are those of the image beyond that radius. Within 85 deg a warning:
such a lens fills the image. Beyond, a note: a fisheye's image circle may end there. It is an error within half the way to the
border, and of radtan and rational within all of it: their terms fold where nothing was calibrated. --max-angle says what counts
as lens.)"},
    Story{"image-size-invalid",
          "Width and height are whole numbers of pixels, at least 1, and what a camera can have at most: a digit too many or "
          "too few."},
    Story{"imu-noise-too-large",
          R"(Asked for is the continuous-time density sigma_c. A discrete deviation at rate f is  sigma_d = sigma_c sqrt(f): at
200 Hz 14 times larger. In degrees a gyroscope's is 57 times larger. People multiply the data sheet's by 5 to 20 for SLAM,
which is allowed for: above 2e-2 rad/s/sqrt(Hz) or 0.2 m/s^2/sqrt(Hz) is reported. Down to a twentieth of that, where a
deviation and a density that was made larger look alike, it is called not decidable.)"},
    Story{"imu-noise-too-small",
          "A variance is the density squared: (1.7e-4)^2 = 2.9e-8. Below 2e-6 rad/s/sqrt(Hz) or 2e-5 m/s^2/sqrt(Hz) is "
          "reported."},
    Story{"imu-rate",
          "IMUs of cameras run at 100 to 1000 Hz; below 20 and above 10000 Hz is reported. 0.2 is kilohertz, 0.005 the step in "
          "seconds."},
    Story{"imu-sensors-swapped", "In SI units a MEMS gyroscope has about 1e-4 and its accelerometer 1e-3."},
    Story{"imu-walk-above-noise",
          "Their units differ (rad/s^2/sqrt(Hz) and rad/s/sqrt(Hz)); the numbers of real gyroscopes differ by 10 and more."},
    Story{"int-for-real",
          R"(Kalibr asks Python for a float, ORB-SLAM3 cv::FileNode for REAL: 190 and 20 are ints to both and refused. A decimal
point fixes it.)"},
    Story{
        "invented-value",
        R"(The target's program stops without the value and no input contains it, so convert took the one that the report names. An
IMU's noise, rate or pose is a fact of the calibration: the file that contains it belongs next to the input.)"},
    Story{
        "inverse-missing",
        R"(calib_results.txt holds two polynomials: pixel to ray (the calibrated one) and ray to pixel (a fit to it). MATLAB's toolbox
leaves the second out unless find_and_export_data was run. fca-io convert FILE --to ocamcalib computes it.)"},
    Story{"json-syntax",
          "RFC 8259: double quotes, no comments, no comma after the last item, no NaN. Python writes NaN and reads it; others "
          "do not."},
    Story{"key-assumed", "The message says which. Whether that is what was meant nothing in the file tells."},
    Story{"key-misspelt",
          R"(A key differs from one that the format has, and that is not there, by a letter: lost, too many, wrong, in the other
case, or exchanged with its neighbour. Digits are no letters. Or a block holds a camera and is not called cam0, cam1, ...)"},
    Story{"left-handed",
          "det R = -1. No motion turns a camera into its mirror image: a sign is wrong, or two rows are exchanged."},
    Story{
        "lens-in-doubt",
        R"(The same numbers can be read as two lenses: by the zeros after them, or by a name that programs take in two ways. fca-io
reads them as the named program does today. Compare it with another calibration of the camera: fca-io compare A B.)"},
    Story{
        "lost",
        R"(The target's program uses the fact (a time offset, an IMU's misalignment, a pose), and the target's files have no place
for it. The report says of each what can be done about it.)"},
    Story{"matlab-origin", "In MATLAB the centre of the first pixel is (1, 1), in OpenCV (0, 0): subtract 1 from cx and cy."},
    Story{"matrix-corner",
          "A camera matrix is [fx s cx; 0 fy cy; 0 0 1]. MATLAB's is its transpose; projection matrices have three rows of "
          "four."},
    Story{"matrix-not-float",
          "Stereo.T_c1_c2, IMU.T_b_c1, Tbc and Tlr are read by .at<float>(); dt: d stores eight bytes per number."},
    Story{
        "matrix-transposed",
        R"(MATLAB writes K' = [fx 0 0; s fy 0; cx cy 1] where OpenCV has [fx s cx; 0 fy cy; 0 0 1]. cx and cy then stand in the last
row, and a program that reads K(0, 2) finds 0.)"},
    Story{
        "matrix-type",
        R"(dt of an !!opencv-matrix: d (double) or f (float), one channel. Integers (i, u) cut the decimals off; 2d has two numbers
per place.)"},
    Story{"merge-conflict",
          "<<<<<<<, ======= and >>>>>>> enclose two versions that git could not merge. Choose one and delete the markers."},
    Story{
        "missing-block",
        R"(calib_results.txt has five blocks: direct polynomial, inverse polynomial, centre, affine c d e, image size. A reader that
finds fewer keeps whatever was in its memory.)"},
    Story{"missing-key", "The message names the key and the program that stops without it."},
    Story{
        "mode-refused",
        R"(A settings file has the keys of one mode: Camera2 and Stereo.* for stereo, RGBD.* for depth, IMU.* for inertial. The message
names the first key that is missing or mistyped for the richest mode that its keys speak for.)"},
    Story{
        "model-contradicts",
        R"(--opencv-model says one lens and the file's own metadata (fisheye_model, distortion_type, xi) the other. One of the two is
not meant.)"},
    Story{"name-unprintable",
          "The name of a camera or topic holds line breaks, control characters or bytes that are not UTF-8."},
    Story{
        "needs-program",
        R"(Programs read different keys of the same format. The file holds those of the program that the message names, and the one
that it was meant for refuses it.)"},
    Story{"no-calibration",
          "The syntax is right and some keys are known; but no camera stands there, and no IMU with noise densities."},
    Story{"no-right-rays",
          R"(For that share of the image the program has no ray, or one that the source does not have there. Up to 1 % is ready,
above 50 % not to be used. What lies outside the lens does not count: --max-angle or --lens-circle say where it ends.)"},
    Story{"not-a-camera",
          R"(The ranges: focal lengths > 0, alpha in [0, 1], beta > 0, xi of Double Sphere in [-1, 1]. Kalibr's lists begin with
[alpha beta ..] for eucm, [xi alpha ..] for ds, [xi ..] for omni: exchanged, alpha leaves its range.)"},
    Story{"not-a-camera-matrix", "3 x 3, [fx s cx; 0 fy cy; 0 0 1], fx and fy above 0."},
    Story{"not-a-list",
          "The message names what the program asks for there. A list is [1.0, 2.0], or a line with a dash for each item."},
    Story{"not-a-mapping", "Keys with values are wanted: `key: value`, with a blank after the colon."},
    Story{"not-a-matrix",
          "K: !!opencv-matrix with rows, cols, dt and data below it; cv::FileStorage makes a matrix of nothing else."},
    Story{"not-a-number",
          "Decimal comma, unit (190 px), letter O, typographic minus: none is part of a number. 190.97 and 1.9e+02 are."},
    Story{
        "not-a-rotation",
        R"(R^T R = I for a rotation. Printed with three digits it is off by 2e-3 at most, with two by 2e-2: above the first is a
warning, above the second an error. The nearest rotation is the orthogonal factor of the polar decomposition R = Q S.
A quaternion must have length 1.)"},
    Story{"not-a-string",
          R"(A number or a list stands where a name is read. Quotes make text of what looks like a number: "1.0".)"},
    Story{"not-a-transform", "If the last column is 0 0 0 1, the matrix is transposed."},
    Story{"not-an-integer", "A count of pixels or frames per second is wanted."},
    Story{
        "not-calibrated",
        "A device that was never calibrated holds zeros for its lens. They are left out: calibrate it, or read it out again."},
    Story{"not-finite", "NaN and infinity are what a calibration leaves that did not converge."},
    Story{"not-in-pixels",
          "rho = k1 theta + ... in pixels: k1 is 200 to 600. Normalised Kannala-Brandt coefficients (0.18) stand there in "
          "forks."},
    Story{"not-positive", "Focal lengths, image sizes, rates and noise densities are above 0."},
    Story{"not-settings", "ORB-SLAM's settings are `Camera.fx: 458.6`, one key below the other at the left margin."},
    Story{
        "number-as-text",
        R"(PyYAML (Kalibr) takes a number for a real one only with a point, and with a sign in the exponent: 1.0e-05. 1e-5 and 1e5
are text to it.)"},
    Story{"octal", "cv::FileStorage and PyYAML take a leading 0 for base 8, as C does: 017 is 15, and 09 is none."},
    Story{"opencv-header",
          R"(%YAML:1.0 is no YAML: the directive is %YAML 1.2 with a blank. One layout is read by PyYAML, yaml-cpp and OpenCV
alike: first line %YAML 1.2, second line ---, lists indented deeper than their key, every real number with a point.)"},
    Story{
        "out-of-range",
        R"(fca-io's limits are far beyond any camera's: they keep arithmetic from overflowing. A number like 1e300 is a digit too many
or uninitialised memory.)"},
    Story{
        "pair-far-apart",
        R"(The two cameras of a stereo file stand more than 2 m apart. Heads that are carried have baselines of 0.05 to 0.3 m, cars
up to 1.5 m: the unit may be another one, or the translation another pair's.)"},
    Story{
        "pair-rolled",
        R"(The rotation between the cameras is taken apart into a turn about the axis and one of the axis. The first is more than 60
deg: rectification turns each image by half of it.)"},
    Story{
        "pair-turned",
        R"(The axes of the two cameras are more than 60 deg apart: rectification makes both look between them, where a pinhole image
shows little of either.)"},
    Story{"part-missing",
          R"(VINS-Fusion's configuration names its camera files (cam0_calib, cam1_calib), relative to its own folder. Each is
looked for there and checked as a file of its own.)"},
    Story{
        "pixels-off",
        R"(Every pixel of the image has a ray in the source, and the program images that ray somewhere else. Measured is the distance,
of a wide lens inside the inscribed circle of the image: up to 0.25 px rms and 1 px for 99 % is ready, above 2 px rms or 5 px not
to be used. What goes wrong is the model that was fitted, or numbers that the program takes otherwise.)"},
    Story{"polynomial-sign",
          "OCamCalib's camera looks along -z: f(0) = a0 < 0, some -200 to -2000 px. A positive one is another toolbox's sign."},
    Story{
        "pose-doubtful",
        R"(Some devices print a pose twice with other numbers, or in a direction on which their readers do not agree. fca-io says
how it read it; measure the distance on the device before you rely on its sign.)"},
    Story{"pose-implausible",
          "WoodScape's frame stands on the ground: x ahead, y left, z up. Cameras of a car are 0.4 to 1.5 m above it."},
    Story{"pose-inverted",
          R"(T_a_b takes points in b to points in a. Kalibr: T_cam_imu (imu -> cam), T_cn_cnm1 (previous camera -> this one).
ORB-SLAM3: IMU.T_b_c1 and Tbc (cam -> imu), Stereo.T_c1_c2 and Tlr (second -> first). WoodScape: camera -> vehicle.
A pose and its inverse are equally long, so that a single one tells nothing; it is decided by the other poses of a loop,
or by the height above a vehicle's ground.)"},
    Story{"pose-missing", "Two cameras, and no pose leads from one to the other (T_cn_cnm1, R and T, Stereo.T_c1_c2)."},
    Story{"pose-transposed",
          R"(R' is the inverse of R: the rotation goes the other way, and the translation, given for the first, no longer fits.
MATLAB multiplies rows (p' R), Eigen stores columns: either way rows become columns on the way into a file.)"},
    Story{
        "poses-contradict",
        R"(T_cam1_imu = T_cam1_cam0 T_cam0_imu. Programs print them from one estimate, to 1e-15; edited files break the loop. Above
0.06 deg or 1 mm a warning, above 0.5 deg or 1 cm an error. A pose whose inverse, transpose or millimetres would close the
loop is named as such.)"},
    Story{
        "program-finds-no-camera",
        R"(OpenCV prescribes no keys: every program looks for its own. Known are camera_matrix (the calibration sample), M1 and K1
(stereo_calib), camera_matrix_left, camera_0.)"},
    Story{"program-ignores", "The key is right for another version or program. Harmless, unless you rely on it."},
    Story{"program-misreads",
          "The program loads the file and then uses a part of it otherwise than it is meant, or not at all; the message says "
          "which. In pixels: fca-io show FILE --for PROGRAM."},
    Story{"program-other-format", "Every program reads one format. The command below the finding writes it."},
    Story{
        "program-refuses",
        R"(The file was given to the program's reader, rebuilt from its source: the message says what it stumbles over. Where another
spelling of the same value would do, --fix makes it.)"},
    Story{"python-syntax",
          "mrcal's files are dicts of Python, which ast.literal_eval reads: texts in quotes, numbers, lists, comments, and no "
          "nan, inf, names or sums."},
    Story{"real-for-int", "Kalibr's resolution, ORB-SLAM3's Camera.fps and sizes are ints: 30.0 is refused."},
    Story{
        "rectification-contradicts",
        R"(R1, R2 and P2 state a pose of the second camera: T = R2' (R1 p + (P2(0, 3) / fx, 0, 0)). It is compared with R and T:
above 0.5 deg or 5 % of the baseline is an error, above a tenth of that a warning. Somebody has edited the one and not the
other.)"},
    Story{
        "relative-by-centre",
        R"(DSO's camera.txt: centre and focal length below 1 are parts of the width and height, and half a pixel is subtracted. A
centre of 0.5 px cannot be distinguished from that.)"},
    Story{"ros-parameters",
          "A ROS 2 launch file passes /**: ros__parameters: ... to a node. Kalibr and others read a calibration at the top of "
          "a file."},
    Story{"size-contradicts", "--size tells what a file does not say. This one says otherwise."},
    Story{"size-needed", "A device's memory has a lens for each resolution. --size WxH chooses that of the recorded images."},
    Story{
        "size-swapped",
        R"(The principal point is within a tenth of the middle of the image turned by 90 deg, and a fifth away from the middle of
the one given.)"},
    Story{"size-unlike-centre",
          R"(cx / (w / 2) and cy / (h / 2) are alike, and 30 % and more from 1: the intrinsics are those of another resolution.
Scaled by s they become  f' = s f,  c' = s (c + 0.5) - 0.5.)"},
    Story{
        "skew",
        R"(K(0, 1): pixels whose rows and columns are not at right angles. Calibrated skews are noise. radtan, rational, kb4 and mei
are read with one; other formats have no place for it, and it is fitted away.)"},
    Story{"stale-inverse", "The inverse polynomial is a fit to the direct one, to 0.01 px when fresh. Above 1 px is reported."},
    Story{"stereo-order",
          "T_c1_c2 takes points of camera 2 to camera 1: its translation is where camera 2 stands, x > 0 for the right one."},
    Story{
        "stereo-vertical",
        R"(ORB-SLAM rectifies a pair of pinholes and looks for the points of one image along the rows of the other. Of a pair whose
second camera stands more below or above the first than next to it the points move along columns.)"},
    Story{
        "tangential-too-large",
        R"(p1 and p2 say how far the lens is tilted against the sensor: below 0.01 on real lenses. Larger ones make up for what
the views did not show. Next to a k1 and k2 below 0.3, as fisheyes have them, they are taken for its k3 and k4: wrong-family.)"},
    Story{
        "target-cannot-reach",
        R"(Some models end: radtan and rational fold, a pinhole has no ray at 90 deg. The fit then covers the part that they reach,
and the rest of the lens has wrong pixels or none. Another model, or --max-angle where the rest is not needed.)"},
    Story{
        "time-offset-large",
        R"(t_imu = t_cam + timeshift_cam_imu, in seconds. At 20 Hz a frame takes 0.05 s: more than that pairs images with the motion of
another one. Milliseconds (5.3) look so, and clocks that were never set.)"},
    Story{"too-deep", "More than 64 lists within lists. A calibration has three."},
    Story{"too-large", "More than 2 MiB. The largest calibration seen has 193 kB; images and point lists make the rest."},
    Story{"too-long", "The limit is 100,000 values in one list, keys in one block, or lines."},
    Story{"too-many-cameras", "The limit is 100 cameras: their poses are compared each with each."},
    Story{"translation-in-mm",
          R"(Kalibr, ORB-SLAM3 and WoodScape use metres. Parts of a rig more than 5 m apart are a warning, 50 m an error: 110 mm
read as metres are 110 m. Two cameras less than a millimetre apart are a warning, too. OpenCV's stereo calibration has the
unit of the board.)"},
    Story{"undistortion-inexact", R"(cv::undistortPoints inverts the lens by

  x <- (x0 - tangential(x)) / radial(x)

and stops after five steps without looking at what is left. The steeper the distortion the slower it is, and where the
radius of the image hardly grows with the angle it walks away. Told is how far the lens images the found ray from the pixel
that was asked for; above 1 px is reported. cv::undistort and remapping are not concerned: they go from ray to pixel.)"},
    Story{
        "units-not-stated",
        R"(OpenCV's stereo calibration gives T in the unit of the board's squares: metres, centimetres or millimetres. Compare its
length with the distance of the two lenses.)"},
    Story{"unknown-format", "fca-io formats lists what is read, and by which keys it is recognised."},
    Story{"unknown-model", "The message names those that the program knows. fca-io models has the other names of each."},
    Story{"unquoted-text",
          "File.version: 1.0 is a number to OpenCV; PinHole # a comment is text with its comment. Quotes fix both."},
    Story{
        "utf-16",
        "Windows' editors and redirections in PowerShell save text as UTF-16, two bytes for a character. No program that reads "
        "calibrations expects it."},
    Story{"wrong-count",
          "The first number of OCamCalib's polynomials is how many follow; rows x cols of a matrix is how many numbers data "
          "holds; COLMAP's binary files begin with how many cameras or rigs they hold."},
    Story{"wrong-family", R"(Four numbers look alike in every file. What tells them apart:
* radtan's p1 and p2 are below 0.01 on real lenses; k3 and k4 of an equidistant model often are not (next to a k1 and k2 below
  0.3, which fisheyes have; else: tangential-too-large).
* no lens without distortion sees 100 deg across the image; an equidistant model's k1 near 0 under radtan claims one.
* an equidistant model with |k1| > 0.15 has higher terms of its size; radtan's -0.28 0.07 0.0002 -0.00002 under its name
  ends in next to nothing.
Not decidable: small numbers of a narrow lens, where both readings see the same.)"},
    Story{"wrong-length", "The message says how many numbers the model has, and in which order."},
    Story{"wrong-syntax", "The message says what is expected in that line."},
    Story{"xml-declaration",
          "OpenCV's files have none. An entity can pull in other files or grow to gigabytes: it is not followed."},
    Story{"xml-mixed", "OpenCV's XML has either text or elements in an element."},
    Story{"xml-place", "Items of a list are <_>; elsewhere an element's name is its key."},
    Story{"xml-root", R"(cv::FileStorage wants <?xml version="1.0"?> and <opencv_storage>.)"},
    Story{"xml-syntax",
          "An unclosed element or a missing quote; the place is where the reader gave up, the cause is often a line before."},
    Story{"yaml-alias",
          "*name stands for another part of the file, <<: *name adds its keys. PyYAML follows them, cv::FileStorage does not. "
          "fca-io reads such a file and does not edit it: a value would change in two places."},
    Story{"yaml-anchor", "&name marks a part for reuse. PyYAML follows it, cv::FileStorage does not; write the values out."},
    Story{"yaml-documents", "A second --- begins a second document: programs read the first, or stop. Make two files of it."},
    Story{"yaml-key", "A list or map as a key, which no calibration has: usually a bracket or dash out of place."},
    Story{
        "yaml-layout",
        R"(cv::FileStorage (OpenCV, ORB-SLAM, OpenVINS) wants a first line %YAML and lists indented deeper than their key; what
Kalibr writes has neither. This is read by PyYAML, yaml-cpp and OpenCV alike:

  %YAML 1.2
  ---
  cam0:
    T_cam_imu:
      - [0.1, 0.2, 0.3, 0.4]

--fix adds the line and the blanks, and changes no number.)"},
    Story{
        "yaml-syntax",
        R"(The place is where the reader gave up; the cause is often the line before: an open bracket or quote, a missing colon, an
indentation that fits no key above it.)"},
    Story{"yaml-tab", "YAML indents with blanks only; OpenCV and PyYAML both refuse TABs there."},
};

}  // namespace

std::span<const Story> stories() { return kStories; }

std::string_view story_of(std::string_view code) {
  const auto* const found = std::ranges::lower_bound(kStories, code, {}, &Story::code);
  return found == kStories.end() || found->code != code ? std::string_view() : found->text;
}

}  // namespace fca::cli
