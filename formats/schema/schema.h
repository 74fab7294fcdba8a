// SPDX-License-Identifier: BSD-3-Clause
// A format as a table: which fact of a rig is under which key. The same table serves to read files, to compose fresh ones, to
// edit files, to find the node of a fact and to list what the format cannot hold.
//
// A row (Key) has two functions: `read` reads facts of the rig from a node, `write` returns the text of the key for a rig.
// keys.h has the rows that several formats share. The functions of a row that only one format needs are next to that format's
// table.
#pragma once

#include "../fields.h"

#include <fca/formats/format.h>

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fca::schema {

enum class FactKind {
  kOther,  ///< A value for which a rig has no member. It is kept as an extra field or not at all.
  kModel,
  kParameter,
  kImageSize,
  kPose,
  kTimeOffset,
  kFrameRate,
  kTopic,
  kImu,
  kBaseline,
};

/// One number of a rig. The camera to which the number belongs is not part of it.
struct Fact {
  FactKind kind = FactKind::kOther;
  std::string_view parameter = {};            ///< kParameter: the parameter's name.
  std::optional<double> Imu::*imu = nullptr;  ///< kImu
  const PoseEdge* pose = nullptr;             ///< kPose: a pose of the rig.
  int row = 0;  ///< kPose: row of an element of T_a_b, or -1 for any element of its rotation. kImageSize: 0 width, 1 height.
  int column = 0;
  bool operator==(const Fact&) const = default;
};

/// A key with the tokens of its value, and the fact that each token contains, in the same order. `facts` may be shorter than
/// the list of tokens: the facts are then those of the first tokens.
struct Statement {
  fields::Field field;
  std::vector<Fact> facts = {};
};

/// A single statement, with `fact` as the fact of its first token.
[[nodiscard]] inline std::vector<Statement> states(fields::Field field, const Fact& fact = {}) {
  return {{std::move(field), {fact}}};
}

/// A program's name for a lens, and our model for it.
struct Lens {
  std::string_view name;   ///< "pinhole-radtan8"
  std::string_view model;  ///< "rational"
  /// An additional key next to the parameters, which is no parameter of the model. Empty if there is no such key.
  std::string_view further = {};
  double none = 0.0;  ///< The number under `further` in a fresh file.
};

/// A lens that a file describes by two names and two lists of numbers: fx fy cx cy, and coefficients.
struct ListLens {
  std::string_view model;             ///< Our model's id. The first entry that can represent a camera is written.
  std::string_view camera_model;      ///< "pinhole"
  std::string_view distortion_model;  ///< "radial-tangential"
  std::span<const ParameterId> coefficients = {};
  std::size_t zeros = 0;                     ///< The number of zeros after the coefficients in the list.
  std::span<const ParameterId> absent = {};  ///< Parameters of the model that are not in the list and must be 0.
  bool any_length = false;                   ///< The list may have any length, because the program ignores the list.
  Code found = {};                           ///< A diagnostic for files with this lens. {0} the camera, {1} and {2} its names
};

/// How a file contains a pose T_frame_camera: a translation [m] and a quaternion x y z w, under seven keys or as two lists.
/// The members of type Code are messages; a format that never needs one leaves it empty. {0}, {1} ... are their arguments.
struct PoseLayout {
  std::string_view frame;  ///< "imu0", "vehicle"
  FrameKind kind;
  std::span<const std::string_view> translation;  ///< Three keys, or the key of a list of three numbers.
  std::span<const std::string_view> rotation;     ///< Four keys, or the key of a list of four numbers.
  bool rotation_first = false;                    ///< In a fresh file the rotation comes before the translation.
  /// A quaternion with a length in this range is accepted and scaled to 1; others are an error.
  double shortest = 0.0;
  double longest = std::numeric_limits<double>::infinity();
  Code no_pose = {};       ///< The value is neither an object nor a list. {0} the pose
  Code wrong_length = {};  ///< The length of the quaternion is not 1. {0} the pose, {1} the length
  Code zero_length = {};   ///< The length of the quaternion is 0. Arguments as for `wrong_length`.
  /// The rig's matrix is not exactly a rotation, and the nearest rotation is written. {2} the frame, {3} the largest
  /// difference. Without this code, quaternions are computed from the matrix as it is.
  Code restated = {};
  Code in_frame = {};  ///< A default value: the pose in the frame of another camera, {0}, instead of `frame`.
  Code identity = {};  ///< A default value: the identity, because no pose is known.
  Code made_up = {};   ///< A sentence around one of these two default values, {0}. Without it, the value stands alone.
};

struct Key;

/// The keys of an object.
struct Mapping {
  std::span<const Key> keys;                       ///< The rows, in the order in which they are read.
  std::span<const std::string_view> written = {};  ///< The order of keys in a fresh file; empty: the order of `keys`.
  /// Entries whose key no row has are kept as extra fields, with this prefix before their names. nullopt: they are not kept.
  std::optional<std::string_view> unread = {};
  /// Duplicate keys get a warning. Of several entries with the same key, only the one that programs with this dialect read is
  /// kept as an extra field.
  bool warns_of_duplicates = false;
  bool stops_at_error = false;  ///< Reading ends at the first key that cannot be read.
  Code missing = {};            ///< One warning about all missing keys, {0}, that only the program {1} requires. Empty: none.
};

/// The diagnostic if the key is missing: none, a warning or an error.
enum class Need { kOptional, kWanted, kRequired };

/// Whether a row is one value, or one value for each camera or IMU.
enum class Spread {
  kOnce,
  kCounted,   ///< A list with one item for each camera; its length is the number of cameras.
  kEach,      ///< A list with one item for each camera.
  kSomeEach,  ///< A list like kEach that may have fewer or more items than there are cameras.
  kNamed,     ///< One value for each camera; its key is the camera's name.
  kNamedImu,  ///< One value for each IMU; its key is the IMU's name.
};

struct Reading;
struct Subject;

/// The data of a row's functions. Each function uses some of the members; the others are empty.
struct Details {
  const Mapping* mapping = nullptr;  ///< The keys of an object.
  std::span<const Lens> lenses = {};
  std::span<const ListLens> list_lenses = {};
  const PoseLayout* pose = nullptr;
  std::optional<ParameterId> parameter = {};
  std::optional<double> Imu::*imu = nullptr;
  /// The key, in the same object, of the other half of the fact (e.g. the width, for the row of the height). For tuning(): the
  /// prefix of the extra field's key. For matrix(): the key of the object, for messages.
  std::string_view other = {};
  std::string_view list = {};   ///< The key, in the same object, of the lens's coefficients.
  std::string_view token = {};  ///< The value in a fresh file.
  std::size_t count = 0;        ///< The length of a list.
  double initial = 0.0;         ///< The program's initial value, for a fresh file.
  double per_second = 1.0;      ///< Units of a time in a second: 1e9 for nanoseconds.
  bool only_edited = false;     ///< A fresh file does not get this key.
  bool only_warns = false;      ///< The row only adds diagnostics. The value is kept as if no row had its key.
  bool real = false;            ///< A whole number is written with a decimal point.
  bool of_imu = false;          ///< The text belongs to the IMU, and is always quoted.
};

/// A row of the table.
struct Key {
  using Read = bool (*)(Reading& reading, const Key& key, const text::Node& node);
  using Write = std::vector<Statement> (*)(const Subject& subject, const Key& key);
  using Edit = void (*)(text::Document& document, const text::Node& node, const Key& key, const Subject& before,
                        const Subject& after, Written& written);

  std::string_view name;
  FactKind fact = FactKind::kOther;
  Read read = nullptr;    ///< Returns false, with an error, if the node does not contain the fact. Null: another row reads it.
  Write write = nullptr;  ///< Returns nothing if the rig does not have the fact; an edit then keeps the file's value.
  Details with = {};
  Edit edit = nullptr;  ///< Null: an edit replaces the numbers that `write` spells differently before and after the edit.
  bool inside = false;  ///< `write` returns the entries of the mapping under the key instead of the key itself.
  Need need = Need::kOptional;
  Spread spread = Spread::kOnce;

  [[nodiscard]] std::string text() const { return std::string(name); }
};

/// The codes of a format's diagnostics. {0}, {1} ... are their arguments.
struct Codes {
  Code wrong_syntax = {};       ///< The input is not a single document whose root is a mapping.
  Code missing = {};            ///< There is no key {0}. {1}: `unless_wanted` or empty. Without this code: "missing-key".
  Code missing_below = {};      ///< {0} has no key {1}. {2}: `unless_wanted` or empty.
  Code wrong = {};              ///< {0} is no mapping. Last argument: `unless_wanted` or empty. Without this code: no_object.
  Code unless_wanted = {};      ///< A clause that the three messages above contain if the key is wanted but not required.
  Code no_object = {};          ///< {0} is no mapping.
  Code no_camera_list = {};     ///< {0} is no list of cameras.
  Code no_list = {};            ///< {0} is no list of {1} items, one for each camera.
  Code item_count = {};         ///< {0} has {1} items, and there are {2} cameras.
  Code unknown_model = {};      ///< {0} has a model {1}.
  Code unknown_lens = {};       ///< {0} has a camera model {1} with a distortion model {2}.
  Code coefficient_count = {};  ///< {0} has {1} numbers; a distortion model {3} has one of the numbers {2}.
  Code not_four = {};           ///< {0}, the number of rows or columns, is {1} instead of 4.
  Code no_identity = {};        ///< {0}, the IMU's pose in the body, is not the identity.
  Code unknown_parameter = {};  ///< {0}'s {1} is no parameter of {2}.
  Code no_size = {};            ///< {0}'s value is no list of width and height.
  Code offset_not_whole = {};   ///< {0} is {1}, which is no whole number.
  Code offset_invalid = {};     ///< {0} is no valid time offset. {1}: the reason.
  Code initial_value = {};      ///< A default value: {0}, the initial value of the program {1}.
  Code one_offset = {};         ///< A clause: the file has one time offset for all cameras.
  Code offset_rounded = {};     ///< The time offset {2} is rounded to the file's unit.
  Code further_imu = {};        ///< The IMU {0} is lost, because the file has only one IMU.
};

/// A format.
struct Schema {
  std::string_view what;  ///< The format's name in messages: "a Basalt calibration".
  text::Dialect dialect;
  Mapping root;
  Codes codes;
  std::string_view program = {};  ///< The program that reads the files, for messages about missing keys and initial values.
  bool one_camera = false;        ///< The document contains one camera, called "cam0" if it does not name it.
  std::string_view model = {};    ///< With one_camera: the id of our model of the camera, if all files have the same model.
  bool numbers_in_lines = false;  ///< In a fresh file, each number of a list is on its own line.
};

/// The state while a rig is read.
struct Reading {
  const Schema& schema;
  fields::Reader& reader;
  const ReadOptions& options;
  Rig& rig;
  std::string owner;                    ///< What the keys belong to, for messages: "value0", "cam0 intrinsics".
  const text::Node* mapping = nullptr;  ///< The mapping that contains the key being read.
  Camera* camera = nullptr;             ///< The camera being read; null where keys belong to no single camera.
  Imu* imu = nullptr;                   ///< The IMU being read; null in files with at most one IMU.
  std::string_view lens =
      {};  ///< The name of the camera's lens in the file; empty before the name is read, and if it is unknown.
  const ListLens* list_lens = nullptr;  ///< The lens, in formats with two names for it; null before the names are read.

  /// The value under a key as messages name it: "cam0 resolution" for a camera, otherwise the key.
  [[nodiscard]] std::string label(const Key& key) const {
    return ((camera != nullptr || imu != nullptr) && !owner.empty() ? owner + " " : "") + std::string(key.name);
  }
};

/// What the rows of a table write: a rig, and the camera or IMU of it whose keys are being written.
struct Subject {
  const Schema& schema;
  const Rig& rig;
  std::size_t camera = 0;
  std::size_t imu = 0;
  Written* fresh = nullptr;  ///< For a fresh file: receives default values and losses. Null in an edit.

  [[nodiscard]] const Camera& the_camera() const { return rig.cameras[camera]; }
};

/// A fresh YAML file. `head`: its first lines, before the keys. nullopt, with an error, if the text cannot be parsed.
[[nodiscard]] std::optional<text::Document> composed_yaml(const Subject& subject, std::string head, std::string name,
                                                          Diagnostics& diagnostics);

/// The YAML lines of a mapping and of the mappings in it, for a fresh file. `depth`: blanks before the first level; `deeper`:
/// additional blanks for each further level.
[[nodiscard]] std::string yaml_lines(const Subject& subject, const Mapping& mapping, std::size_t depth, std::size_t deeper);

/// Reads a document by the table; nullopt, with errors, if it contains no calibration.
[[nodiscard]] std::optional<Rig> read(const Schema& schema, std::span<const text::Document> documents,
                                      const ReadOptions& options, Diagnostics& diagnostics);
/// Reads the keys of one mapping of a document. False, with errors, if a key cannot be read.
[[nodiscard]] bool read_mapping(Reading& reading, const Mapping& mapping, const text::Node& node);
/// Adds to the rig, as extra fields of `owner`, the entries of the mapping and of the mappings in it that no row reads.
void keep_unread(Reading& reading, const Mapping& mapping, const text::Node& node, const std::string& owner);
/// The value under a key; null, with the diagnostic of its Need, if it is missing or (with codes.wrong) must be a mapping and
/// is none.
[[nodiscard]] const text::Node* find_value(Reading& reading, const Key& key, const text::Node& mapping);

/// A fresh JSON file of a rig or, if schema.one_camera, of one camera. Each level is indented by two more blanks.
[[nodiscard]] std::string composed_json(const Schema& schema, const Rig& rig, std::size_t camera, Written& written);

/// True if both rigs have cameras with the same names in the same order. Only then can a file be edited.
[[nodiscard]] bool same_cameras(const Rig& old, const Rig& rig);
/// A copy of the document `base`, which contains `before`, in which the numbers that differ in `after` are replaced. Both rigs
/// must have the same cameras.
[[nodiscard]] text::Document edited(const text::Document& base, const Subject& before, const Subject& after, Written& written);

/// Edits one mapping of a document, at any depth, in the same way as edited(). `node`: the mapping in the document.
void edit(text::Document& document, const Mapping& mapping, const text::Node& node, const Subject& before, const Subject& after,
          Written& written);

/// The node that contains a fact of camera number `camera` (ignored for facts of the IMU); null if there is none.
[[nodiscard]] const text::Node* place_of(const Schema& schema, const text::Document& document, const Rig& rig,
                                         std::size_t camera, const Fact& fact);

/// True if the table has a key that writes facts of that kind.
[[nodiscard]] bool holds(const Schema& schema, FactKind kind);
/// Adds to `losses` what the file rounds or has no key for: time offsets, topics, frame rates, IMUs, the baseline. `why`: the
/// reason, a clause in the messages.
void list_losses(const Schema& schema, const Rig& rig, const Message& why, std::vector<Loss>& losses);
/// The extra fields of the rig that a fresh file contains.
[[nodiscard]] std::vector<ExtraField> carried(const Schema& schema, const Rig& rig);

/// The keys of a mapping in the order of a fresh file.
[[nodiscard]] std::vector<const Key*> in_written_order(const Mapping& mapping);
/// The fields of the statements, without their facts.
[[nodiscard]] std::vector<fields::Field> fields_of(std::vector<Statement> statements);
/// The fields that a mapping's rows write, sorted by key, without those of rows for facts of the kind `but`.
[[nodiscard]] std::vector<fields::Field> sorted_fields(const Subject& subject, const Mapping& mapping, FactKind but);

}  // namespace fca::schema
