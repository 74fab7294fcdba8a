// SPDX-License-Identifier: BSD-3-Clause
// What a format is: files of one layout, read into a Rig and written from one. The registry (registry.cc) is the table of them.
#pragma once

#include <fca/convert/convert.h>
#include <fca/diagnostics.h>
#include <fca/formats/opencv_model.h>
#include <fca/formats/text/document.h>
#include <fca/rig/rig.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fca {

/// How a reader is to understand what a file leaves open.
struct ReadOptions {
  std::optional<ImageSize> image_size;      ///< For files that do not specify one.
  std::optional<OpenCvModel> opencv_model;  ///< Of OpenCV files whose four numbers could be either's.
  bool join = false;  ///< Further documents are further cameras of one rig: a name that is taken becomes the next "camN".
  std::optional<double> length_unit_m = {};  ///< Of translations in files that do not specify it; default: metres.
  std::optional<double> imu_rate_hz = {};    ///< Of the IMU, where a file does not specify it.
};

/// Written::sensor of a file for a program of lenses in a format of rigs (DSO's camera.txt): it uses no pose and no IMU.
inline constexpr std::string_view kLensAlone = "lens-alone";

/// A way in which a format stores a camera model, and who reads it.
struct StoredModel {
  std::string_view model;                  ///< Our id.
  std::string_view file_name;              ///< The file's name for it: "pinhole-equidistant", "KannalaBrandt8".
  bool stock = true;                       ///< Read by the format's own program; false: a dialect that only forks read.
  std::string_view read_by;                ///< Programs, for people.
  std::span<const ParameterRange> ranges;  ///< What the program demands beyond the model's own ranges (EUCM alpha > 0.5).
  Code why = {};                           ///< Why it demands that, a clause.
  bool pairs_only = false;                 ///< A file holds one such camera, or a pair with its pose, and no other rig.
  std::string_view since = {};             ///< The program's version that first reads it: "2022"; empty: each does.
};

/// Something the target format cannot carry: of whom, which fact, its values. fca/formats/wording.h words it.
struct Loss {
  Code kind = {};                     ///< Code::kTimeOffsetDropped
  std::string owner = {};             ///< A camera by its name in the rig ("cam0"), an IMU, a file; empty: the rig.
  std::string key = {};               ///< "timeshift_cam_imu"
  std::vector<Argument> values = {};  ///< 0.0021
  bool matters = false;               ///< The target's program uses the fact; the conversion decides it.
};

/// A loss by its facts, which its sentences name as {0} (owner), {1} (key), {2} ... (values).
[[nodiscard]] inline Loss lost(Code kind, std::string owner, std::string key, std::vector<Argument> values = {}) {
  return {kind, std::move(owner), std::move(key), std::move(values)};
}

/// A value the inputs do not specify and the target demands. fca/formats/wording.h words it.
struct DefaultedValue {
  std::string key;
  Argument value;           ///< As the file spells it, or a clause.
  bool look_at_it = false;  ///< The user must check it (fps, colour order); the others are tuning with upstream's value.
  bool invented = false;    ///< A fact of the calibration that no input specifies: an IMU's noise or pose, the unit of lengths.
  std::string file = {};    ///< Of several files the name of that which holds it, where that is one without cameras.
};

struct Format;
namespace schema {
struct Schema;  // formats/schema/schema.h
}

/// What a format specifies and a Rig has no member for.
struct OwnFact {
  std::string_view name;                        ///< For people: "IMU intrinsics".
  std::span<const std::string_view> keys = {};  ///< That state it (ExtraField::key); none: all others.
};

/// What a format's program demands and calibrations rarely state.
struct Demand {
  std::string_view name;           ///< For people: "colour order".
  std::string_view key;            ///< Part of the keys that are written for it (DefaultedValue): "Camera.RGB".
  bool Format::*of = nullptr;      ///< It is demanded only of what can hold this: an IMU's topic. Null: of everything.
  bool Format::*stated = nullptr;  ///< What can hold this specifies it. Null: only what demands the same does.
  std::string_view of_model = {};  ///< It is demanded of this model only, and computed again.
  bool of_frame = false;           ///< It is a pose in Format::frame, which a format with that frame specifies.
};

/// What a writer is asked for.
struct WriteOptions {
  std::string sensor;  ///< orbslam3: "mono", "stereo", ...; empty: the richest the rig serves.
  std::string layout;  ///< One of Format::layouts; empty: the base file's, else the stock program's.
  std::optional<double> frame_rate_hz;
  std::optional<double> max_angle_rad;  ///< What counts as lens, from the axis; nothing: as far as the model goes.
  std::string
      extension;  ///< Of the file to be written, with its point (".xml"), for formats with several syntaxes; may be empty.
  bool rewrite = false;  ///< Compose a file though there is a base: of that only what tunes the program is taken over.
  /// Further files whose cameras are joined to the rig: only the base can be edited, their comments go.
  std::span<const text::Document> joined = {};
  /// The base's owner has a program for it: it stays in that program's layout, whatever the model.
  bool keeps_layout = false;
  /// Names of the base's cameras whose place another camera takes: what was set for their images is not of the new one's.
  std::vector<std::string> replaced = {};
  /// All files of the input that is edited, of which one is the base: another may go along (COLMAP's rigs).
  std::span<const text::Document> input = {};
  /// The file's names of the models that a program takes, for one that reads fewer than the format stores; empty: all.
  std::span<const std::string_view> models_taken = {};
  bool lenses_alone = false;  ///< For a program that reads nothing of how cameras sit to each other.
  bool adopted = false;  ///< The base was read as another format of the same layout: a camchain that is to become TUM-VI's.
};

/// What was written and what the user must know of it.
struct Written {
  struct File {
    text::Document document;            ///< Bytes with edits; its source's name is a proposal ("imu.yaml", "cam1.txt").
    std::vector<std::string> cameras;   ///< Names, as in the rig, of the cameras in it.
    std::vector<std::string> programs;  ///< Ids of the consumers meant to read it.
    /// Another of the files names it: it lies next to that one, under its source's name.
    bool named = false;
    std::string place = {};    ///< Its path in a folder of the program's own ("mav0/cam0/sensor.yaml"); empty: any name does.
    bool of_defaults = false;  ///< It specifies nothing of the rig, but what the program stops without.
    /// As its own format reads it once it is written (write_calibration()); nothing where that does not, or where nobody asks.
    std::optional<Rig> says = {};
  };
  std::vector<File> files;
  Message headline;                         ///< First line for people: mode, who reads it, who does not.
  std::string sensor;                       ///< orbslam3: the mode written for; or kLensAlone.
  std::optional<OpenCvModel> opencv_model;  ///< opencv: what a reader must be told where the file does not say it.
  Message first_is_left;  ///< Why the first of two cameras is to be the left one, for people; none: nothing asks for it.
  Message pose_remedy;    ///< What to do about poses that the files do not say; may be none.
  std::vector<Loss> losses;
  std::vector<DefaultedValue> defaults;
  /// That the files specify, between cameras by the rig's names: they are read back (write_calibration()).
  std::vector<PoseEdge> poses = {};
  bool states_rectification = false;  ///< The files specify Rig::rectified.
  std::vector<PoseEdge> restated;  ///< Poses that the files say otherwise than the rig, on purpose; each is among the losses.
};

/// What speaks for a format, by its weight. Formats for which the same speaks tie, and the user is asked.
namespace evidence {
inline constexpr int kCamera = 90;  ///< Keys of a camera that only this format has.
inline constexpr int kPart = 80;    ///< Keys of another part: an IMU's noise, a header.
inline constexpr int kTuning = 70;  ///< Keys of its program's tuning.
inline constexpr int kHint = 60;    ///< Less than that: a key without what belongs under it, a pose alone.
}  // namespace evidence

/// How sure a format is that a document is one of its own. 0: not at all.
struct ProbeResult {
  int score = 0;
  Message why = {};  ///< "top-level cam0 with camera_model and intrinsics"
};

/// Between which numbers a value makes sense to the program that reads it.
struct ValueRange {
  double lowest = 0.0;
  double highest = 0.0;
};

/// What a value is to a program that reads it.
enum class ValueType { kInteger, kReal, kText };

/// Under which heading a format is listed.
enum class FormatGroup {
  kCalibration,     ///< Written by programs that calibrate, and libraries that compute with cameras.
  kSlam,            ///< Settings of odometry and SLAM.
  kReconstruction,  ///< Structure from motion, radiance fields.
  kDatasets,
  kDevices,  ///< Memories of devices, written in a factory.
};

/// What the files of a format say of a rectified stereo pair.
enum class RectifiedFiles : std::uint8_t {
  kNone,
  kImages,   ///< The camera of the rectified images, and the baseline.
  kCameras,  ///< Both cameras as they take the images, and how these are rectified.
};

/// A row of the registry.
struct Format {
  std::string_view id;
  std::string_view title;
  FormatGroup group = FormatGroup::kSlam;
  std::string_view syntaxes;                     ///< For people: "YAML".
  std::string_view extension;                    ///< Of its files, with the point: ".yaml".
  std::string_view program;                      ///< The stock program that reads it: "Kalibr".
  std::string_view main_file = "camchain.yaml";  ///< The file with the cameras, where its other parts lie next to it.
  std::string_view binary_file = {};             ///< The same in a folder of binary files; empty: there are none.
  bool reader_warns = false;                     ///< What its program misreads its reader says itself, at the place.
  std::string_view layout_of = {};      ///< Id of the format whose files its own are, with habits of their own; may be empty.
  bool many_cameras = true;             ///< In one file; else a rig is written as one file per camera.
  std::size_t most_cameras = SIZE_MAX;  ///< That its program uses at once; further ones are not converted.
  bool begins_with_pair = false;        ///< Its program takes the first two cameras for a stereo pair.
  bool undistorts_points = false;       ///< Programs that read it call cv::undistortPoints.
  bool one_model = false;               ///< All its cameras are of one model.
  bool extrinsics = true;
  bool poses_apart = false;      ///< A file of cameras alone is whole: their poses, if anybody needs them, stand in another.
  bool facts_apart = false;      ///< Poses and IMU noise, which its program uses, stand in a file of another kind.
  bool pair_poses = false;       ///< Of the poses between cameras it specifies that of a stereo pair only, the rig's first two.
  bool any_length_unit = false;  ///< Its files do not say in what unit translations are; metres elsewhere.
  bool metres_by_custom = false;  ///< Its files do not specify the unit of translations, and are in metres as a rule.
  bool imu = true;
  bool imu_pose = false;          ///< Where `imu` is false: it says where the IMU sits, and nothing of its noise.
  bool noise_of_samples = false;  ///< Its IMU noise is one sample's; its reader makes densities of it.
  bool needs_imu = false;         ///< Its program does nothing without an IMU: its calibrations specify one.
  bool imu_file = false;          ///< An IMU without cameras is a file of its own: Kalibr's imu.yaml.
  bool image_size = true;
  bool time_offset = false;
  bool frame_rate = false;
  bool topic = false;
  bool baseline = false;        ///< Of a rectified pair or depth sensor, without a pose.
  std::string_view frame = {};  ///< That it specifies poses in, besides those of cameras and IMUs: "vehicle".
  std::span<const OwnFact> own_facts = {};
  std::span<const std::string_view> modes = {};    ///< What WriteOptions::sensor may say; empty: nothing.
  std::span<const std::string_view> layouts = {};  ///< What WriteOptions::layout may say; empty: there is one layout.
  Code about_layouts = {};                         ///< "v1 (stock V1.0), old (before V1.0), ...", a clause.
  /// One of `layouts`, in which two fisheyes are written with one set of lens parameters, since the program takes the first
  /// one's for both.
  std::string_view common_lens_layout = {};
  RectifiedFiles rectified = RectifiedFiles::kNone;
  bool leaves_model_open = false;  ///< Some of its files do not show which of two models they hold (ReadOptions).
  std::span<const Demand> demands = {};
  /// Keys of own facts (ExtraField::key) that count pixels or rows of the images, and are stale for others.
  std::span<const std::string_view> of_the_images = {};
  /// Keys of own facts that were computed from the cameras and their poses, and are stale next to others.
  std::span<const std::string_view> of_the_lenses = {};
  /// Keys of own facts that name cameras by their numbers (1: cam1): who renames those recounts these.
  std::span<const std::string_view> of_cameras = {};
  std::span<const StoredModel> models;
  const schema::Schema* table = nullptr;  ///< Which fact stands under which key; null where the format has no table yet.

  ProbeResult (*probe)(const text::Document& document);

  /// The range of a value that no calibration specifies and that may be set, in a file that says `rig`; nothing where none is
  /// known. Null: of none.
  std::optional<ValueRange> (*range_of)(std::string_view key, const Rig& rig) = nullptr;

  /// The type of a value ('/' between the levels of its key) that the document may lack, that its program reads where it is
  /// there, and that no calibration contradicts: it may be added. Nothing of any other key. Null: of none.
  std::optional<ValueType> (*optional_value)(const text::Document& document, std::string_view key) = nullptr;

  /// Can the document hold the model without another layout? Null: any model that the format stores.
  bool (*layout_holds)(const text::Document& document, std::string_view model) = nullptr;
  /// How many of the rig's cameras, from the first, does a fresh file hold in that mode and layout ("": those chosen for the
  /// rig)? Null: `most_cameras`.
  std::size_t (*cameras_held)(const Rig& rig, std::string_view mode, std::string_view layout) = nullptr;
  /// Does a fresh file in that layout, one of `layouts`, hold the model? Null: any model that the format stores.
  bool (*layout_stores)(std::string_view layout, std::string_view model) = nullptr;

  /// Where the document names files that are parts of its calibration, as paths relative to its folder. Null: it names none.
  std::vector<const text::Node*> (*parts)(const text::Document& document) = nullptr;

  /// Where a document's numbers are of other images than those that its camera is of (ROS's binning and roi): the camera as the
  /// numbers say it. Nothing of any other document. Null: the numbers are the camera's.
  std::optional<Camera> (*as_stated)(const text::Document& document, const Camera& camera) = nullptr;

  /// Does its program look along rows for the matches of a stereo pair of that model? It finds none where one camera stands
  /// above the other. Null: of no model.
  bool (*matches_along_rows)(std::string_view model) = nullptr;

  /// A camera as arguments of its program's command line, "--ImageReader.camera_model OPENCV ...", with the model by which the
  /// written `file` calls its camera number `index`. Null: it takes none.
  std::string (*arguments)(const Camera& camera, const text::Document& file, std::size_t index) = nullptr;

  /// Gives the cameras of a rig, once all of its files are read, what a file without cameras says of them (Kimera's
  /// imu_time_shift). Null: none does.
  void (*complete)(Rig& rig) = nullptr;

  /// Documents that together are one calibration, or nothing with errors. Those of parts() follow the one that names them.
  std::optional<Rig> (*read)(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics);

  /// Edits `base` (a document this format read) so that it says what `rig` says; only fields in which the two differ are
  /// touched; cameras are recognised by their names. With no base a fresh file is composed. Every model of `rig` must be one of
  /// `models`. Losses are listed but for those of poses and comments: write_calibration() finds them. Null: no program reads
  /// such a file from others (a device's own memory), and the format is read only.
  std::optional<Written> (*write)(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                  Diagnostics& diagnostics) = nullptr;

  [[nodiscard]] constexpr bool is_written() const { return write != nullptr; }
  /// May a unit of translations be told?
  [[nodiscard]] constexpr bool leaves_unit_open() const { return any_length_unit || metres_by_custom; }
};

/// All formats, in the order in which they are listed and asked: those that are written, then those that are only read.
[[nodiscard]] std::span<const Format> all_formats();
[[nodiscard]] std::span<const Format> written_formats();
/// The format of that id or alias ("orb-slam3", "ORB_SLAM3"), in any case; null if there is none.
[[nodiscard]] const Format* find_format(std::string_view name);

/// Is a document that was read as `from` one that `to` can edit: of that very format, or of one with the same layout?
[[nodiscard]] bool is_base_of(const Format& from, const text::Document& document, const Format& to);

/// The row of `format` for a model; stock rows first. Null if it cannot store it.
[[nodiscard]] const StoredModel* find_stored_model(const Format& format, std::string_view model, bool stock_only);

/// Can the format hold this camera: its model, and its parameters (EUCM's alpha for the forks, k3 in a camchain)? An error if
/// not: the caller is to convert the camera first.
[[nodiscard]] bool can_store(const Format& format, const Camera& camera, Diagnostics& diagnostics);
/// The same of all cameras, but for those that `there` (the file to be edited; may be null) already holds as they are.
[[nodiscard]] bool can_store(const Format& format, const Rig& rig, const Rig* there, Diagnostics& diagnostics);

}  // namespace fca
