// SPDX-License-Identifier: BSD-3-Clause
// A calibration converted to another format, and to another camera model if need be: read, fitted, written in memory, proven.
#pragma once

#include <fca/convert/parameter_range.h>
#include <fca/convert/report.h>
#include <fca/formats/check.h>
#include <fca/formats/format.h>
#include <fca/formats/proof.h>
#include <fca/formats/set_value.h>
#include <fca/formats/verdict_value.h>
#include <fca/rectify/vertical_disparity.h>
#include <fca/toolkit/files.h>
#include <fca/toolkit/format_word.h>
#include <fca/toolkit/inputs.h>
#include <fca/toolkit/status.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fca {

/// One camera before and after. No report where nothing was computed (the model is kept and the image size unknown).
struct ConvertedCamera {
  Camera source;
  Camera target;
  std::optional<ConversionReport> report;
  std::string name_in_file = {};  ///< What the file written calls it; empty: as the input does.
  Diagnostics found = {};         ///< Of its conversion.

  /// The written name.
  [[nodiscard]] const std::string& name() const { return name_in_file.empty() ? source.name : name_in_file; }
  /// The share of the image that the target does not reach; 0 where nobody notices.
  [[nodiscard]] double unrepresented_share() const {
    constexpr double kNoticeable = 5e-4;
    const double share = report ? report->statistics.coverage.unrepresentable : 0.0;
    return share > kNoticeable ? share : 0.0;
  }
};

/// A file that was made. Nothing is on the disk yet.
struct ConvertedFile {
  std::string name;  ///< A proposal: "imu.yaml".
  std::string path;  ///< Where it goes, as the request has it; empty: nowhere in particular.
  std::string bytes;
  text::Syntax syntax = text::Syntax::kYaml;
  std::vector<std::string> cameras;   ///< Names of the cameras in it, as in the input.
  std::vector<std::string> programs;  ///< Ids of the consumers that are meant to read it.
  bool named = false;                 ///< Another of the files names it: it lies next to that one.
  std::string place = {};             ///< In a folder of its program's own ("mav0/cam0/sensor.yaml"); empty: any name does.
  bool of_defaults = false;           ///< It specifies nothing of the input.

  /// Does it only stand where its program looks for it?
  [[nodiscard]] bool is_filler() const { return of_defaults && cameras.empty() && programs.empty(); }
};

/// A comment in the written file: its inputs, the conversion, its errors.
enum class ProvenanceComment : std::uint8_t { kInFreshFiles, kInAllFiles, kNone };

struct ConvertResult;

/// What there is a place for.
struct OutputRoom {
  bool camera_files = true;   ///< Several files with cameras; else more than one is an error.
  bool named_files = true;    ///< Files that another one names; else they are an error.
  bool further_files = true;  ///< Files without cameras (Kalibr's imu.yaml); else they are left out, as a loss.
  /// Files that specify nothing and that the program wants in its folder (COLMAP's images.txt); else they are left out.
  bool fillers = true;
  bool given_parts = true;  ///< A part of the input may be left out so; else that is an error.
};

struct ConvertRequest {
  Inputs inputs;
  const Format* to = nullptr;  ///< Null: that of `into`.
  /// Who is to read the files first, of those that read the format; null: the format's own program.
  const consumers::Consumer* program = nullptr;
  const ModelInfo* model = nullptr;    ///< Null: the input's, else the best that the format's own program reads.
  std::optional<FormatMode> mode;      ///< Nothing: the richest that the input serves.
  std::optional<FormatLayout> layout;  ///< Nothing: the base's, else the stock program's.
  std::string into;                    ///< Path of the file whose text is edited; empty: none.
  bool rewrite = false;                ///< A fresh file even where a text could be edited.
  std::string extension;  ///< As in the written file's path, with its point. Formats with several syntaxes go by it.
  Objective objective = Objective::kRms;
  WeightKind weight = WeightKind::kPixel;         ///< Of Objective::kRms: what counts how much in a fit.
  std::string weight_image;                       ///< Path of the image of WeightKind::kImage, as large as the new images.
  std::shared_ptr<const GreyImage> density = {};  ///< That image; null: it is read.
  std::optional<int> degree;  ///< Of a fitted polynomial (ocamcalib); nothing: the lowest that is nearly as good as any.
  FixedParameters fixed;      ///< Of the fitted models.
  bool absorb_turn = false;   ///< A turn of each camera is fitted, too, and written into its poses; for Objective::kRms.
  bool fit_pair = false;  ///< A stereo pair is fitted together (fca/convert/pair_fit.h), turns included; for Objective::kRms.
  bool every_pixel = false;  ///< Errors are those of every pixel, not of a lattice of about 5,000 points.
  /// Also what no verdict depends on: errors if the lens ended earlier (ConversionReport::max_angles), and whether the input's
  /// own program would refuse the input.
  bool in_detail = false;
  /// ConvertOptions::errors_of_kept
  bool errors_of_kept = true;
  std::optional<double> frame_rate_hz;  ///< For formats that specify it.
  std::optional<double> baseline_m;     ///< Of a rectified pair or depth sensor.
  std::vector<KeyValue> settings;       ///< Values of the written file that no calibration specifies.
  std::optional<double> max_error_px;   ///< kRejected if a camera's largest error is more.
  /// kRejected if a camera's error is anywhere more than so many standard deviations of the calibration's own pixels; of a
  /// camera without a covariance a bad request.
  std::optional<double> max_error_sigmas;
  bool strict = false;  ///< kRejected if anything of the input is lost.
  /// The cameras as arguments of the program's command line (Format::arguments), as one file in place of the others.
  bool as_arguments = false;
  bool verify = true;                ///< The programs that read the files are asked about their bytes.
  std::vector<Acceptance> accepted;  ///< Reasons against the file that do not stop it.
  ProvenanceComment provenance = ProvenanceComment::kInFreshFiles;
  std::string made_by;   ///< For that comment: the command or program that asks; empty: none.
  std::size_t jobs = 0;  ///< Cameras at the same time; 0: as many as there are processors.
  OutputRoom room;
  /// The path of a file of the result, for messages and for the file's `path`; null: files have none.
  std::function<std::string(const ConvertResult& result, std::size_t file)> path_of;
};

/// Another way to write the same, for the same program: how far it understands the worst camera.
struct OtherWriting {
  std::string layout;
  std::string model;  ///< Of all cameras.
  double rms_px = 0.0;
  double max_px = 0.0;
};

/// The same model fitted to less of the lens, where that is better for the program.
struct NearerFit {
  double max_angle_deg = 0.0;  ///< From the axis: all that the images' inscribed circles show.
  double rms_px = 0.0;         ///< In the circles, of the worst camera.
};

/// What came of it. Where `status` is neither kDone nor kRejected, only what was reached is set.
struct ConvertResult {
  Status status = Status::kDone;
  const Format* from = nullptr;
  bool one_format = true;  ///< False: `from` is the first file's, and others joined to it have another.
  const Format* to = nullptr;
  bool lens_given = false;  ///< By an angle or a circle: shares are of the lens.
  std::vector<ConvertedCamera> cameras;
  std::vector<ConvertedFile> files;
  std::vector<PoseEdge> poses;  ///< That the files specify, between cameras by the input's names.
  Message headline;             ///< Mode, who reads it, who does not.
  std::string mode;             ///< That was written for.
  std::string layout;  ///< That was chosen because the program understands it best; empty: asked for, or the usual one.
  Verdict verdict;     ///< Whether to use the files.
  std::vector<Finding> findings;     ///< What is wrong with the meaning of the input and of what was written.
  double rms_px = 0.0;               ///< Of the camera that the program understands worst.
  double max_px = 0.0;               ///< At the worst pixel of all.
  std::optional<PairError> pair;     ///< Of the stereo pair among the written cameras, if there is one.
  std::optional<NearerFit> nearer;   ///< Nobody asked for it.
  std::vector<OtherWriting> others;  ///< Ways that were tried and are worse or, if one is asked for, better.
  std::vector<Loss> losses;
  std::vector<DefaultedValue> defaults;
  std::vector<ProofResult> proofs;
  std::vector<std::string> unproven;        ///< Paths of files that no known program reads; "" is a file without one.
  std::vector<std::string> refused_before;  ///< Programs that refuse the file as they did before it was edited.
  std::vector<CameraChoice> better_order;   ///< Of the cameras, where the first two are exchanged; empty: they are not.
  Diagnostics diagnostics;
};

/// The extension of a file that is to be written, with its point.
[[nodiscard]] std::string extension_of(const ConvertedFile& file, const Format& format);
/// Is the extension (with its point) one that calibration files have?
[[nodiscard]] bool is_calibration_extension(std::string_view extension);
/// How many of the files hold cameras and have no name that another one gives them.
[[nodiscard]] std::size_t camera_files(const std::vector<ConvertedFile>& files);

/// Why a request cannot be one for files of a format that has no such thing as what it specifies (a frame rate, a mode, a
/// layout of another format): "option-without-use". None if it can.
[[nodiscard]] Message without_use(const ConvertRequest& request, const Format& to);

/// Never throws for bad input: the result's status and diagnostics tell.
[[nodiscard]] ConvertResult convert(const ConvertRequest& request, Files& files);

}  // namespace fca
