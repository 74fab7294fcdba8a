// SPDX-License-Identifier: BSD-3-Clause
// Kept by name, so that a story is found by eye; a test compares the table with the codes.
#include "stories.h"

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

constexpr std::array kStories = {
    Story{
        "a1-not-zero",
        R"(OCamCalib fits  f(rho) = a0 + a2 rho^2 + a3 rho^3 + a4 rho^4  with a1 = 0: the surface is flat on the axis. The file
lists the coefficients from a0 upwards, so its second number is 0. If it is not 0, the list is in MATLAB's descending
order, lacks a1, or belongs to another program.)"},
    Story{
        "ambiguous-format",
        R"(The file contains keys of two formats. The first line of the finding names both formats, with the keys of each. --from
FORMAT decides. Usually somebody pasted one file into another: separate them.)"},
    Story{
        "ambiguous-model",
        R"(cv::projectPoints reads four numbers as k1 k2 p1 p2 of a radial-tangential lens; cv::fisheye reads them as k1 k2 k3 k4
of an equidistant lens. An OpenCV file need not name the model. The finding shows both readings, with the angle that
each would see across the image. Compare the angles with the lens's data sheet, then give --opencv-model pinhole or
fisheye.)"},
    Story{"baseline-contradicts",
          R"(Camera.bf = b fx, with the baseline b in metres and fx of the rectified camera in pixels. The file gives the same
baseline a second time, as RIGHT.P(0, 3) = -b fx or in the second camera's pose. fca-io reports differences of more than
5 %.)"},
    Story{"baseline-is-bf",
          R"(Stereo.b in ORB-SLAM3's new settings is the baseline in metres; Camera.bf in the older ones is  bf = b fx.  fca-io
suspects bf above 5 m, if Stereo.b / fx is between 0.02 and 2 m. Millimetres can look the same (47.9 is 0.11 m times 435
px, and also 47.9 mm): then the message shows both.)"},
    Story{"bf-is-a-baseline",
          "Camera.bf, or focal_x_baseline, is the baseline in metres times fx in pixels: 0.11 m and 435 px give 47.9."},
    Story{
        "binary-file",
        R"(The file contains a zero byte, or a value with bytes that are not UTF-8. It may be an image, an archive or UTF-16 text.
If it is text, save it as UTF-8.)"},
    Story{
        "blank-missing",
        R"(OpenCV's reader accepts key:2. For every other YAML parser key:2 is one word: it misreads or skips what follows, and its
own error message is about a later line. --fix adds the space.)"},
    Story{
        "byte-order-mark",
        R"(Windows editors begin UTF-8 files with the bytes EF BB BF, which no editor shows. cv::FileStorage (OpenCV, ORB-SLAM,
OpenVINS) and Python's json take them for content and stop; PyYAML skips them. --fix removes them.)"},
    Story{"cannot-read",
          "The operating system cannot open the file: it does not exist, is a folder, or you have no permission to read it."},
    Story{
        "carla-translation",
        R"(CARLA is left-handed and has another origin, and the published files differ in the order of y and z. fca-io does not
guess: it leaves the pose out.)"},
    Story{
        "centre-off",
        R"(fca-io compares |cx - (w - 1) / 2| with w / 2, and |cy - (h - 1) / 2| with h / 2, and reports a ratio above 0.3. Real
lenses stay below 0.1. Causes: a cropped image, numbers of another resolution, exchanged numbers, or a poor calibration.)"},
    Story{"centre-outside",
          R"(This is centre-off with a ratio above 1. It is right only for a crop that does not contain the middle of the lens.
Kalibr refuses a negative principal point.)"},
    Story{
        "centre-swapped",
        R"(calib_results.txt gives the centre as row, column and the size as height, width; MATLAB's DistortionCenter is column,
row. fca-io reports the centre if the other order puts it at most half as far from the middle of the image, and if it is
now more than 0.03 image diagonals from the middle. For an almost square image, nobody can tell.)"},
    Story{
        "coefficient-repeated",
        R"(Two of k1 ... k6, p1, p2 are equal to the last digit, with at least five digits. Estimated numbers never are: one was
copied over the other.)"},
    Story{
        "comment-lines",
        R"(get_ocam_model reads calib_results.txt by lines: it skips one line and reads one block, five times. If a block has two
comment lines before it, the reader takes the second for the numbers. Blank lines count as comment lines.)"},
    Story{"comment-missing",
          "get_ocam_model skips exactly one line before each of its five blocks, whatever the line contains."},
    Story{"comment-too-long",
          "get_ocam_model reads a comment with fgets into a buffer of 1024 bytes, and takes the rest of a longer line for "
          "numbers."},
    Story{
        "cr-line-ends",
        R"(Old Macs ended lines with CR alone. OpenCV's and OCamCalib's readers look for LF and see a single line; PyYAML (Kalibr)
also accepts CR.)"},
    Story{"degree-too-high", "MATLAB's default is degree 4. The message gives the highest degree that fca-io can hold."},
    Story{"depth-threshold",
          R"(ORB-SLAM counts a point as close if it is nearer than ThDepth * baseline; then one view gives its depth. Upstream's
examples have 35 to 60. Values such as 0.1 or 2000 are probably metres or millimetres. With 0 or less, no point is
close.)"},
    Story{"distortion-missing",
          R"(Without coefficients, OpenCV's functions assume a lens without distortion. That is right for rectified images. For
others, add D, distortion_coefficients or D1 next to the matrix.)"},
    Story{"duplicate-key",
          R"(PyYAML keeps the last of two equal keys; yaml-cpp and cv::FileStorage keep the first. None of them warns. So two
programs read two calibrations from one file. Delete the key that is wrong.)"},
    Story{
        "empty-file",
        R"(The file contains nothing, or only spaces and line ends. A program that crashed while writing, or a full disk, leaves
such files.)"},
    Story{
        "eucm-without-type",
        R"(ns15417/slam_no_opt reads EUCM's alpha and beta from Camera.k1 and Camera.k2 if Camera.type is EUCM. Without Camera.type
they are radial distortion: k1 = 0.6 and k2 = 1.1 bend the image beyond recognition.)"},
    Story{
        "file-version-missing",
        R"(ORB-SLAM3 V1.0 reads its new keys (Camera1.fx) only if File.version is the string "1.0". Without it, the program looks
for Camera.fx and stops.)"},
    Story{
        "file-version-not-string",
        R"(ORB-SLAM3 compares a string: File.version: "1.0". cv::FileStorage reads 1.0 without quotes as a number, which is not
equal to that string.)"},
    Story{
        "focal-length-not-in-pixels",
        R"(With a focal length below 0.05 image widths, an equidistant lens would see more than 1100 deg across the image; above 20
image widths, less than 3 deg. Millimetres (4.2) and normalised numbers (0.83) are too short; a number without its
decimal point is too long.)"},
    Story{
        "focal-lengths-differ",
        R"(Nearly every sensor of the last twenty years has square pixels, so fca-io reports a difference of more than 5 %. For
anamorphic images such a difference is right.)"},
    Story{"folds-inside-image", R"(A polynomial that fits the calibrated part of the image may turn back beyond that part:

  radius |        ___
         |     .-'   '-.      <- from here on two rays share a pixel
         |   .'
         |  /
         +---------------- angle from the axis

The message gives the angle at which the radius stops growing, and the share of the image beyond that radius. Below 85 deg
it is a warning, because such a lens fills the image. Above, it is a note, because a fisheye's image circle may end there.
It is an error within half of the way to the border; for radtan and rational within all of it, because their terms fold
where nothing was calibrated. --max-angle sets where the lens ends.)"},
    Story{
        "image-size-invalid",
        R"(Width and height must be whole numbers of pixels, at least 1, and not larger than any camera's. Often the number has a
digit too many or too few.)"},
    Story{
        "imu-noise-too-large",
        R"(The file needs the continuous-time noise density sigma_c. The standard deviation of one sample at the rate f is  sigma_d
= sigma_c sqrt(f),  at 200 Hz 14 times larger. A gyroscope's noise in degrees is 57 times larger. Many people multiply
the data sheet's noise by 5 to 20 for SLAM, and fca-io allows that: it reports more than 2e-2 rad/s/sqrt(Hz) or 0.2
m/s^2/sqrt(Hz). Between a twentieth of that and the limit, an enlarged density and a sample's deviation look alike:
fca-io then cannot decide.)"},
    Story{"imu-noise-too-small",
          R"(A variance is the square of the density: (1.7e-4)^2 = 2.9e-8. fca-io reports less than 2e-6 rad/s/sqrt(Hz) or 2e-5
m/s^2/sqrt(Hz).)"},
    Story{
        "imu-rate",
        R"(IMUs of cameras run at 100 to 1000 Hz. fca-io reports rates below 20 Hz and above 10000 Hz. A value of 0.2 is probably
in kHz; 0.005 is probably the period in seconds.)"},
    Story{"imu-sensors-swapped",
          "A MEMS gyroscope has about 1e-4 rad/s/sqrt(Hz), and its accelerometer about 1e-3 m/s^2/sqrt(Hz)."},
    Story{
        "imu-walk-above-noise",
        R"(The units differ: rad/s^2/sqrt(Hz) for the random walk, rad/s/sqrt(Hz) for the noise. In real gyroscopes the number of
the random walk is at least 10 times smaller.)"},
    Story{
        "int-for-real",
        R"(Kalibr asks Python for a float, ORB-SLAM3 asks cv::FileNode for REAL. For both, 190 and 20 are ints, and they refuse
them. A decimal point (190.0) fixes it.)"},
    Story{"invented-value",
          R"(The target's program stops without the value, and no input contains it, so convert wrote the value that the report
names. An IMU's noise, rate and pose are part of the calibration: also give the file that contains them.)"},
    Story{"inverse-missing",
          R"(calib_results.txt holds two polynomials: pixel to ray (the calibrated one) and ray to pixel (a fit to it). MATLAB's
toolbox leaves out the second one unless you run find_and_export_data. fca-io convert FILE --to ocamcalib computes it.)"},
    Story{
        "json-syntax",
        R"(JSON (RFC 8259) has double quotes, no comments, no comma after the last item and no NaN. Python writes and reads NaN;
other programs do not.)"},
    Story{"key-assumed",
          "The message names the key and the default. The file does not show whether that default is right for your camera."},
    Story{
        "key-misspelt",
        R"(A key differs by one letter from a key of the format that is missing: a letter is lost, added, wrong, in the wrong case,
or exchanged with its neighbour (digits do not count as letters). Or a block contains a camera but is not called cam0,
cam1, ...)"},
    Story{"left-handed",
          "The determinant of R is -1. No motion turns a camera into its mirror image: a sign is wrong, or two rows are "
          "exchanged."},
    Story{
        "lens-in-doubt",
        R"(The same numbers can be read as two lenses: because zeros follow them, or because programs use the model's name in two
ways. fca-io reads them as the named program does today. Compare the file with another calibration of the camera: fca-io
compare A B.)"},
    Story{
        "lost",
        R"(The target's program uses the value (a time offset, an IMU's misalignment, a pose), but the target's files have no place
for it. The report gives a remedy for each.)"},
    Story{"matlab-origin",
          "In MATLAB the centre of the first pixel is (1, 1), in OpenCV it is (0, 0). Subtract 1 from cx and cy."},
    Story{"matrix-corner",
          "A camera matrix is [fx s cx; 0 fy cy; 0 0 1]. MATLAB writes its transpose. Projection matrices have three rows of "
          "four."},
    Story{
        "matrix-not-float",
        R"(ORB-SLAM3 reads Stereo.T_c1_c2, IMU.T_b_c1, Tbc and Tlr with .at<float>(), four bytes per number. With dt: d the file
stores eight.)"},
    Story{
        "matrix-transposed",
        R"(MATLAB writes K' = [fx 0 0; s fy 0; cx cy 1] where OpenCV has [fx s cx; 0 fy cy; 0 0 1]. Then cx and cy are in the last
row, and a program that reads K(0, 2) gets 0.)"},
    Story{"matrix-type",
          R"(An !!opencv-matrix of a calibration has dt: d (double) or f (float), with one channel. Integers (i, u) cut off the
decimals; 2d stores two numbers per element.)"},
    Story{"merge-conflict",
          "<<<<<<<, ======= and >>>>>>> enclose two versions that git could not merge. Choose one and delete the markers."},
    Story{
        "missing-block",
        R"(calib_results.txt has five blocks: direct polynomial, inverse polynomial, centre, affine c d e, image size. A reader
that finds fewer keeps whatever was in its memory.)"},
    Story{"missing-key", "The message names the key and the program that stops without it."},
    Story{
        "mode-refused",
        R"(A settings file has the keys of one mode: Camera2 and Stereo.* for stereo, RGBD.* for depth, IMU.* for inertial. fca-io
takes the mode with the most of these keys; the message names its first key that is missing or has the wrong type.)"},
    Story{
        "model-contradicts",
        R"(The two descriptions are --opencv-model and the file's own metadata (fisheye_model, distortion_type, xi), or two keys of
the file. One of them is wrong.)"},
    Story{"name-unprintable",
          "The name of a camera or topic contains line breaks, control characters or bytes that are not UTF-8."},
    Story{"needs-program",
          R"(Programs read different keys of the same format. The file has the keys of the program that the message names; the
program that you chose refuses them.)"},
    Story{"no-calibration",
          "The syntax is right and fca-io knows some of the keys, but the file contains no camera and no IMU with noise "
          "densities."},
    Story{
        "no-right-rays",
        R"(For this share of the image the program computes no ray, or a wrong one. Up to 1 % the verdict is ready; above 50 % it
is do not use. Pixels outside the lens do not count: --max-angle or --lens-circle sets where it ends.)"},
    Story{
        "not-a-camera",
        R"(The ranges are: focal lengths > 0, alpha in [0, 1], beta > 0, xi of Double Sphere in [-1, 1]. Kalibr's lists begin with
[alpha beta ..] for eucm, [xi alpha ..] for ds, [xi ..] for omni. If two numbers are exchanged, alpha leaves its range.)"},
    Story{"not-a-camera-matrix", "A camera matrix is 3 x 3: [fx s cx; 0 fy cy; 0 0 1], with fx and fy above 0."},
    Story{"not-a-list",
          "The message names what the program expects. A list is [1.0, 2.0], or one line with a dash for each item."},
    Story{"not-a-mapping", "The program expects keys with values: `key: value`, with a space after the colon."},
    Story{"not-a-matrix",
          "Write K: !!opencv-matrix with rows, cols, dt and data below it. cv::FileStorage reads nothing else as a matrix."},
    Story{
        "not-a-number",
        R"(A decimal comma, a unit (190 px), the letter O and a typographic minus are not part of a number. 190.97 and 1.9e+02 are
numbers.)"},
    Story{
        "not-a-rotation",
        R"(A rotation has R^T R = I. Printed with three digits it is off by at most 2e-3, with two digits by 2e-2. fca-io warns
above 2e-3, and reports an error above 2e-2. The nearest rotation is the orthogonal factor of the polar decomposition R
= Q S. A quaternion must have length 1.)"},
    Story{"not-a-string",
          R"(The program expects a name, but the file has a number or a list. Quotes turn a number into text: "1.0".)"},
    Story{"not-a-transform", "If the last column is 0 0 0 1, the matrix is transposed."},
    Story{"not-an-integer", "The program expects a count, such as pixels or frames per second."},
    Story{
        "not-calibrated",
        R"(A device that was never calibrated holds zeros for its lens. fca-io leaves them out: calibrate the device, or read its
memory again.)"},
    Story{"not-finite", "A calibration that did not converge leaves NaN or infinity."},
    Story{
        "not-in-pixels",
        R"(WoodScape's polynomial  rho = k1 theta + ...  is in pixels: k1 is 200 to 600. Some forks write normalised Kannala-Brandt
coefficients (0.18) there.)"},
    Story{"not-positive", "Focal lengths, image sizes, rates and noise densities are above 0."},
    Story{"not-settings", "ORB-SLAM's settings are lines such as `Camera.fx: 458.6`, each at the left margin."},
    Story{
        "number-as-text",
        R"(PyYAML (Kalibr) reads a number as real only if it has a decimal point, and a sign in its exponent: 1.0e-05. It reads
1e-5 and 1e5 as text.)"},
    Story{"octal",
          "cv::FileStorage and PyYAML read a number with a leading 0 in base 8, as C does: 017 is 15, and 09 is not a number."},
    Story{
        "opencv-header",
        R"(%YAML:1.0 is not valid YAML; the directive is %YAML 1.2, with a space. PyYAML, yaml-cpp and OpenCV all read this layout:
first line %YAML 1.2, second line ---, lists indented deeper than their key, a decimal point in every real number.)"},
    Story{"out-of-range",
          R"(fca-io's limits are far beyond any camera's; they keep arithmetic from overflowing. A number like 1e300 has a wrong
exponent or comes from uninitialised memory.)"},
    Story{
        "pair-far-apart",
        R"(The two cameras of a stereo file are more than 2 m apart. Hand-held rigs have baselines of 0.05 to 0.3 m, cars up to 1.5
m. The translation may be in another unit, or belong to another pair.)"},
    Story{
        "pair-rolled",
        R"(fca-io splits the rotation between the cameras into a roll about the optical axis and a turn of the axis. The roll is
more than 60 deg, and rectification turns each image by half of it.)"},
    Story{"pair-turned",
          R"(The optical axes of the two cameras are more than 60 deg apart. Rectification turns both towards the middle between
them, where a pinhole image shows little of either camera's view.)"},
    Story{
        "part-missing",
        R"(VINS-Fusion's configuration names its camera files (cam0_calib, cam1_calib), relative to its own folder. fca-io looks
for them there and checks each of them.)"},
    Story{
        "pixels-off",
        R"(Each pixel of the image has a ray in the source; the program projects that ray to another pixel. fca-io measures the
distance, for a wide lens inside the inscribed circle of the image. Up to 0.25 px rms, and 1 px for 99 % of the pixels,
the verdict is ready; above 2 px rms or 5 px it is do not use. The cause is the fitted model, or numbers that the
program reads differently.)"},
    Story{
        "polynomial-sign",
        R"(OCamCalib's camera looks along -z: f(0) = a0 < 0, about -200 to -2000 px. Another toolbox may write it with a positive
sign.)"},
    Story{
        "pose-doubtful",
        R"(Some devices print a pose twice with different numbers, or in a direction about which programs disagree. The message
tells how fca-io reads it. Measure the distance on the device before you rely on its sign.)"},
    Story{"pose-implausible",
          "WoodScape's frame is on the ground: x forward, y left, z up. A car's cameras are 0.4 to 1.5 m above it."},
    Story{"pose-inverted",
          R"(T_a_b takes points in b to points in a. Kalibr: T_cam_imu (imu -> cam), T_cn_cnm1 (previous camera -> this one).
ORB-SLAM3: IMU.T_b_c1 and Tbc (cam -> imu), Stereo.T_c1_c2 and Tlr (second -> first). WoodScape: camera -> vehicle.
A pose and its inverse have translations of the same length, so one pose alone does not show its direction. fca-io decides
by the other poses of a loop, or by the height above a vehicle's ground.)"},
    Story{"pose-missing", "The file has two cameras, but no pose between them (T_cn_cnm1, R and T, Stereo.T_c1_c2)."},
    Story{"pose-transposed",
          R"(The transpose R' is the inverse of R: the rotation goes the other way, and no longer fits its translation. MATLAB
multiplies rows (p' R), and Eigen stores columns: both can turn rows into columns when a file is written.)"},
    Story{
        "poses-contradict",
        R"(T_cam1_imu = T_cam1_cam0 T_cam0_imu. Programs print all three from one estimate, so they agree to 1e-15; edited files do
not. fca-io warns above 0.06 deg or 1 mm, and reports an error above 0.5 deg or 1 cm. If the inverse, the transpose or
another unit of one pose would make them agree, the message names that pose.)"},
    Story{
        "program-finds-no-camera",
        R"(OpenCV does not define keys: every program looks for its own. fca-io knows camera_matrix (the calibration sample), M1
and K1 (stereo_calib), camera_matrix_left and camera_0.)"},
    Story{"program-ignores", "The key belongs to another version or program. This is harmless unless you rely on it."},
    Story{
        "program-misreads",
        R"(The program loads the file, but ignores a part of it or uses it differently; the message tells which part. fca-io show
FILE --for PROGRAM gives the error in pixels.)"},
    Story{"program-other-format", "Every program reads one format. The command below the finding writes that format."},
    Story{
        "program-refuses",
        R"(fca-io gave the file to its copy of the program's reader, which follows the program's source. The message tells what
stops it. If another spelling of the same value is enough, --fix writes it.)"},
    Story{
        "python-syntax",
        R"(mrcal's files are Python dicts that ast.literal_eval reads: quoted texts, numbers, lists and comments, without nan, inf,
names and sums.)"},
    Story{"real-for-int", "Kalibr's resolution and ORB-SLAM3's Camera.fps and sizes are ints: both programs refuse 30.0."},
    Story{
        "rectification-contradicts",
        R"(R1, R2 and P2 contain a pose of the second camera: T = R2' (R1 p + (P2(0, 3) / fx, 0, 0)). fca-io compares it with R and
T. A difference above 0.5 deg or 5 % of the baseline is an error, above a tenth of that a warning. Somebody has edited
one and not the other.)"},
    Story{
        "relative-by-centre",
        R"(In DSO's camera.txt, a centre and a focal length below 1 are fractions of the width and height, and DSO subtracts half a
pixel. It cannot distinguish that from a centre of 0.5 px.)"},
    Story{
        "ros-parameters",
        R"(A ROS 2 launch file passes /**: ros__parameters: ... to a node. Kalibr and others read a calibration only at the top
level of a file.)"},
    Story{"size-contradicts", "--size is only for files that contain no image size. This file contains another one."},
    Story{"size-needed", "A device's memory has one lens for each resolution. --size WxH chooses the lens for your images."},
    Story{
        "size-swapped",
        R"(The principal point is within a tenth of the middle of an image turned by 90 deg, but at least a fifth away from the
middle of the given image.)"},
    Story{
        "size-unlike-centre",
        R"(cx / (w / 2) and cy / (h / 2) are alike, but differ from 1 by 30 % or more: the intrinsics are for another resolution.
Scaled by s they become  f' = s f,  c' = s (c + 0.5) - 0.5.)"},
    Story{"skew",
          R"(K(0, 1) is the skew: the rows and columns of the pixels are not at right angles. Calibrated skews are mostly noise.
fca-io reads radtan, rational, kb4 and mei with a skew. Other formats have no place for it, and a fit replaces it.)"},
    Story{
        "stale-inverse",
        R"(The inverse polynomial is a fit to the direct one, at first within 0.01 px. fca-io reports more than 1 px: somebody has
changed one polynomial and not the other.)"},
    Story{
        "stereo-order",
        R"(T_c1_c2 takes points of camera 2 to camera 1. Its translation is the position of camera 2, so x > 0 if camera 2 is the
right one.)"},
    Story{"stereo-vertical",
          R"(ORB-SLAM rectifies a pair of pinholes and searches for the points of one image along the rows of the other. If the
second camera is more above or below the first than next to it, the points move along columns.)"},
    Story{
        "tangential-too-large",
        R"(p1 and p2 describe how far the lens is tilted against the sensor: below 0.01 on real lenses. Larger values compensate
for views that the calibration lacked. If k1 and k2 are below 0.3, as in fisheyes, fca-io takes p1 and p2 for k3 and k4
of a fisheye instead and reports wrong-family.)"},
    Story{
        "target-cannot-reach",
        R"(Some models have a maximum angle: radtan and rational fold, and a pinhole has no pixel at 90 deg. The fit then covers
only the part within that angle; the rest of the lens has wrong pixels or none. Use another model, or --max-angle if you
do not need the rest.)"},
    Story{
        "time-offset-large",
        R"(t_imu = t_cam + timeshift_cam_imu, in seconds. At 20 Hz a frame takes 0.05 s: a longer offset pairs an image with the
motion of another image. The number may be in milliseconds (5.3), or the clocks were never synchronised.)"},
    Story{"too-deep", "The file has more than 64 lists within lists. A calibration has three."},
    Story{"too-large",
          "The limit is 2 MiB. The largest known calibration has 193 kB; larger files contain images or lists of points."},
    Story{"too-long", "The limit is 100,000 values in one list, keys in one block, or lines."},
    Story{"too-many-cameras",
          "The limit is 100 cameras, because fca-io compares the poses of each camera with those of every other."},
    Story{
        "translation-in-mm",
        R"(Kalibr, ORB-SLAM3 and WoodScape use metres: 110 mm read as metres are 110 m. Parts of a rig more than 5 m apart give a
warning, more than 50 m an error. Two cameras less than a millimetre apart also give a warning. OpenCV's stereo
calibration has the unit of its board.)"},
    Story{"undistortion-inexact", R"(cv::undistortPoints inverts the lens by

  x <- (x0 - tangential(x)) / radial(x)

and stops after five steps without checking the result. The stronger the distortion, the slower it converges; where the
radius hardly grows with the angle, it diverges. fca-io projects the ray that it finds, and reports a distance of more than
1 px from the original pixel. cv::undistort and remapping are not affected: they go from ray to pixel.)"},
    Story{
        "units-not-stated",
        R"(OpenCV's stereo calibration gives T in the unit of the board's squares: metres, centimetres or millimetres. Compare the
length of T with the distance of the two lenses.)"},
    Story{"unknown-format", "fca-io formats lists the formats that fca-io reads, and the keys by which it recognises them."},
    Story{"unknown-model",
          "The message names the models that the program knows. fca-io models lists the other names of each model."},
    Story{"unquoted-text",
          "OpenCV reads File.version: 1.0 as a number, and PinHole # a comment as text that includes the comment. Quotes fix "
          "both."},
    Story{
        "utf-16",
        R"(Windows editors and PowerShell redirections save text as UTF-16, with two bytes per character. No program that reads
calibrations expects it.)"},
    Story{
        "wrong-count",
        R"(The first number of OCamCalib's polynomials is the number of coefficients that follow; rows x cols of a matrix is the
number of values in data; COLMAP's binary files begin with the number of cameras or rigs.)"},
    Story{"wrong-family", R"(Four numbers look alike in every file. fca-io tells lens models apart by these facts:
* On real lenses, radtan's p1 and p2 are below 0.01; k3 and k4 of an equidistant model often are not. (If k1 and k2 are above
  0.3, which no fisheye has, the finding is tangential-too-large.)
* No lens without distortion sees 100 deg across the image. An equidistant model's small k1, read as radtan, would mean that.
* An equidistant model with |k1| > 0.15 has higher terms of about that size. radtan's -0.28 0.07 0.0002 -0.00002, read as
  equidistant, ends with terms near 0.
fca-io cannot decide if the numbers are small and the lens is narrow: then both models see the same.)"},
    Story{"wrong-length", "The message gives how many numbers the model has, and their order."},
    Story{"wrong-syntax", "The message describes what the line must contain."},
    Story{
        "xml-declaration",
        R"(OpenCV's files do not contain them. An entity can include other files or grow to gigabytes, so fca-io does not follow
it.)"},
    Story{"xml-mixed", "In OpenCV's XML an element contains either text or elements."},
    Story{"xml-place", "List items are <_>; everywhere else the element's name is its key."},
    Story{"xml-root", R"(cv::FileStorage needs <?xml version="1.0"?> and <opencv_storage>.)"},
    Story{"xml-syntax",
          R"(An element is not closed, or a quote is missing. The message gives the place where the reader stopped; the cause is
often one line above.)"},
    Story{
        "yaml-alias",
        R"(*name refers to another part of the file, and <<: *name adds its keys. PyYAML follows them, cv::FileStorage does not.
fca-io reads such a file but does not edit it, because a value would change in two places.)"},
    Story{"yaml-anchor", "&name marks a part for reuse. PyYAML follows it, cv::FileStorage does not. Write the values out."},
    Story{"yaml-documents", "A second --- begins a second document. Split the file into two."},
    Story{"yaml-key",
          "The key is a list or a map, which no calibration has. Usually a bracket or a dash is in the wrong place."},
    Story{
        "yaml-layout",
        R"(cv::FileStorage (OpenCV, ORB-SLAM, OpenVINS) needs a first line %YAML, and lists indented deeper than their key. Kalibr
writes neither. PyYAML, yaml-cpp and OpenCV all read this layout:

  %YAML 1.2
  ---
  cam0:
    T_cam_imu:
      - [0.1, 0.2, 0.3, 0.4]

--fix adds the line and the spaces, and changes no number.)"},
    Story{
        "yaml-syntax",
        R"(The message gives the place where the reader stopped. The cause is often one line above: an open bracket or quote, a
missing colon, or an indentation that fits no key.)"},
    Story{"yaml-tab", "YAML allows only spaces as indentation; OpenCV and PyYAML both refuse TABs there."},
};

}  // namespace

std::span<const Story> stories() { return kStories; }

std::string_view story_of(std::string_view code) {
  const auto* const found = std::ranges::lower_bound(kStories, code, {}, &Story::code);
  return found == kStories.end() || found->code != code ? std::string_view() : found->text;
}

}  // namespace fca::cli
