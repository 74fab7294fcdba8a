// SPDX-License-Identifier: BSD-3-Clause
// Converts a calibration to another format and, if necessary, to another camera model. The steps are: read the files, fit the
// models, write the new files in memory, and prove what the programs read from them.
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

/// One camera before and after the conversion.
struct ConvertedCamera {
  Camera source;
  Camera target;
  /// nullopt if nothing was computed, because the camera keeps its model and its image size is unknown.
  std::optional<ConversionReport> report;
  std::string name_in_file = {};  ///< The camera's name in the written file. Empty: the same as in the input.
  Diagnostics found = {};         ///< Diagnostics of this camera's conversion.

  /// The camera's name in the written file.
  [[nodiscard]] const std::string& name() const { return name_in_file.empty() ? source.name : name_in_file; }
  /// The share of the image that the target model cannot represent. Unnoticeable shares (up to 0.05 %) are returned as 0.
  [[nodiscard]] double unrepresented_share() const {
    constexpr double kNoticeable = 5e-4;
    const double share = report ? report->statistics.coverage.unrepresentable : 0.0;
    return share > kNoticeable ? share : 0.0;
  }
};

/// A file of the result, in memory. Nothing is written to the disk.
struct ConvertedFile {
  std::string name;  ///< A proposed name: "imu.yaml".
  std::string path;  ///< The path from ConvertRequest::path_of. Empty if that is not set.
  std::string bytes;
  text::Syntax syntax = text::Syntax::kYaml;
  std::vector<std::string> cameras;   ///< Names in the input of the cameras that the file contains.
  std::vector<std::string> programs;  ///< Ids of the programs that will read the file.
  bool named = false;                 ///< Another file of the result refers to this one and expects it in the same folder.
  std::string place = {};             ///< Required relative path ("mav0/cam0/sensor.yaml"). Empty: any name will do.
  bool of_defaults = false;           ///< The file contains only defaults, nothing of the input.

  /// True if the file exists only because a program expects a file of this name: it has no content of the input.
  [[nodiscard]] bool is_filler() const { return of_defaults && cameras.empty() && programs.empty(); }
};

/// Which files get a comment that describes their inputs, the conversion, and its errors.
enum class ProvenanceComment : std::uint8_t { kInFreshFiles, kInAllFiles, kNone };

struct ConvertResult;

/// The kinds of files for which the output has a place.
struct OutputRoom {
  bool camera_files = true;  ///< Several files with cameras. If false, more than one is an error.
  bool named_files = true;   ///< Files to which another file refers. If false, such files are an error.
  /// Files without cameras (Kalibr's imu.yaml). If false, they are left out and reported as losses.
  bool further_files = true;
  /// Files without content of the input that a program expects in its folder (COLMAP's images.txt). If false, they are left
  /// out.
  bool fillers = true;
  /// If false, it is an error to leave out a file without cameras whose content comes from an additional part of the input.
  bool given_parts = true;
};

struct ConvertRequest {
  Inputs inputs;
  const Format* to = nullptr;  ///< Format of the files to write. Null: the format of `into`.
  /// The most important of the programs that will read the files. Null: the format's own program.
  const consumers::Consumer* program = nullptr;
  const ModelInfo* model = nullptr;  ///< Null: the input's model or, if that cannot be kept, the best for the format's program.
  std::optional<FormatMode> mode;    ///< nullopt: the mode that uses most of the input.
  std::optional<FormatLayout> layout;  ///< nullopt: the layout of the file that is edited, else that of the format's program.
  std::string into;                    ///< Path of an existing file whose text is edited. Empty: none.
  bool rewrite = false;                ///< Write fresh files even if the text of an existing file could be edited.
  std::string extension;  ///< Extension of the written file, with its dot. It selects the syntax if the format has several.
  Objective objective = Objective::kRms;
  WeightKind weight = WeightKind::kPixel;  ///< The weights of the points in a fit, for Objective::kRms.
  std::string weight_image;                ///< Path of the image for WeightKind::kImage. It has the size of the new images.
  std::shared_ptr<const GreyImage> density = {};  ///< The image for WeightKind::kImage. Null: it is read from `weight_image`.
  /// Degree of a fitted polynomial (ocamcalib). nullopt: the lowest degree that is nearly as good as any.
  std::optional<int> degree;
  FixedParameters fixed;     ///< Parameters that fits do not change.
  bool absorb_turn = false;  ///< Also fit a rotation of each camera, and write it into the poses. For Objective::kRms.
  /// Fit the cameras of a stereo pair together, with rotations (fca/convert/pair_fit.h). For Objective::kRms.
  bool fit_pair = false;
  bool every_pixel = false;  ///< Measure errors at every pixel instead of a lattice of about 5,000 points.
  /// Also compute details on which no verdict depends: the errors if the lens ended at a smaller angle
  /// (ConversionReport::max_angles), and whether the input's own program would refuse the input.
  bool in_detail = false;
  bool errors_of_kept = true;           ///< See ConvertOptions::errors_of_kept.
  std::optional<double> frame_rate_hz;  ///< Frame rate, for formats that store it.
  std::optional<double> baseline_m;     ///< Baseline of a rectified pair or depth sensor.
  std::vector<KeyValue> settings;       ///< Values for keys of the written file that are no part of a calibration.
  std::optional<double> max_error_px;   ///< The status is kRejected if a camera's largest error exceeds this.
  /// The status is kRejected if the error of a camera exceeds, at any pixel, this multiple of the pixel's standard deviation by
  /// the calibration's own covariance. A camera without a covariance then makes the request invalid.
  std::optional<double> max_error_sigmas;
  bool strict = false;  ///< The status is kRejected if anything of the input is lost.
  /// Write the cameras as arguments of the program's command line (Format::arguments), in one file that replaces all others.
  bool as_arguments = false;
  bool verify = true;                ///< Prove what the programs read from the written files.
  std::vector<Acceptance> accepted;  ///< Reasons against the files that the user accepts.
  ProvenanceComment provenance = ProvenanceComment::kInFreshFiles;
  std::string made_by;   ///< The command or program that this comment names as the maker. Empty: none.
  std::size_t jobs = 0;  ///< Number of cameras that are converted at the same time. 0: number of processors.
  OutputRoom room;
  /// Returns the path of a file of the result, for messages and for ConvertedFile::path. Null: the files have no paths.
  std::function<std::string(const ConvertResult& result, std::size_t file)> path_of;
};

/// Another layout and model in which the same program reads the cameras, and the errors of what it reads.
struct OtherWriting {
  std::string layout;
  std::string model;    ///< The model of all cameras.
  double rms_px = 0.0;  ///< Rms error of the camera that the program reads worst.
  double max_px = 0.0;  ///< Largest error.
};

/// A fit of the same model to a smaller part of the lens, where the program reads it better.
struct NearerFit {
  double max_angle_deg = 0.0;  ///< Largest angle from the axis that is visible in the images' inscribed circles.
  double rms_px = 0.0;         ///< Rms error of the worst camera inside these circles.
};

/// The result of convert(). If `status` is neither kDone nor kRejected, the conversion stopped early, and only the members that
/// it had set before are valid.
struct ConvertResult {
  Status status = Status::kDone;
  const Format* from = nullptr;
  bool one_format = true;  ///< False if the input files have several formats. `from` is then the format of the first file.
  const Format* to = nullptr;
  bool lens_given = false;  ///< An angle or image circle limits the lens, and shares are shares of the lens, not of the image.
  std::vector<ConvertedCamera> cameras;
  std::vector<ConvertedFile> files;
  std::vector<PoseEdge> poses;      ///< The poses in the written files, with the cameras' names in the input.
  Message headline;                 ///< The mode, the programs that read the files, and those that do not.
  std::string mode;                 ///< The mode for which the files are written.
  std::string layout;               ///< The layout, if it was chosen because the program reads it best. Otherwise empty.
  Verdict verdict;                  ///< Whether to use the files.
  std::vector<Finding> findings;    ///< Problems with the meaning of the input and of the written files.
  double rms_px = 0.0;              ///< Rms error of the camera that the program reads worst.
  double max_px = 0.0;              ///< Error at the worst pixel of all cameras.
  std::optional<PairError> pair;    ///< Error of the stereo pair among the written cameras, if there is one.
  std::optional<NearerFit> nearer;  ///< A fit to the inscribed circles that is much better there; the files do not contain it.
  /// Alternatives that were tried: worse ones or, if the request fixes the layout or model, better ones.
  std::vector<OtherWriting> others;
  std::vector<Loss> losses;
  std::vector<DefaultedValue> defaults;
  std::vector<ProofResult> proofs;
  std::vector<std::string> unproven;        ///< Paths of files that no known program reads; "" for a file without a path.
  std::vector<std::string> refused_before;  ///< Programs that refuse the edited file, and refused it before the edit, too.
  std::vector<CameraChoice> better_order;   ///< If the first camera should be the second: the right order. Otherwise empty.
  Diagnostics diagnostics;
};

/// The extension of a file of the result, with its dot.
[[nodiscard]] std::string extension_of(const ConvertedFile& file, const Format& format);
/// True if calibration files have this extension, which includes the dot.
[[nodiscard]] bool is_calibration_extension(std::string_view extension);
/// The number of files that contain cameras and to which no other file refers.
[[nodiscard]] std::size_t camera_files(const std::vector<ConvertedFile>& files);

/// A message "option-without-use" if the request sets something that the format does not have (a frame rate, or the mode or
/// layout of another format). An empty message otherwise.
[[nodiscard]] Message without_use(const ConvertRequest& request, const Format& to);

/// Converts the inputs of a request. It does not throw for bad input: the result's status and diagnostics describe the problem.
[[nodiscard]] ConvertResult convert(const ConvertRequest& request, Files& files);

}  // namespace fca
