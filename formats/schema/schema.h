// SPDX-License-Identifier: BSD-3-Clause
// A format as a table: which fact of a rig is under which key. The same table reads files, composes fresh ones, edits them,
// finds the node of a fact and lists what the format cannot hold.
//
// A row (Key) has two total functions: `read` takes a node to facts of the rig, `write` takes the rig to the text of the key.
// keys.h makes the rows that formats share. A row that only one format needs has functions of its own, next to that format's
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
  kOther,  ///< A value that a rig has no member for; it is kept as an extra field.
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

/// One number of a rig. It does not say which camera the number belongs to.
struct Fact {
  FactKind kind = FactKind::kOther;
  std::string_view parameter = {};            ///< kParameter: the parameter's name.
  std::optional<double> Imu::*imu = nullptr;  ///< kImu
  const PoseEdge* pose = nullptr;             ///< kPose: a pose of the rig.
  int row = 0;  ///< kPose: row of an element of T_a_b, or -1 for any element of its rotation. kImageSize: 0 width, 1 height.
  int column = 0;
  bool operator==(const Fact&) const = default;
};

/// A key with the tokens of its value, and the fact that each token contains, in the same order. A single fact may be that of
/// the first token only.
struct Statement {
  fields::Field field;
  std::vector<Fact> facts = {};
};

/// The statement of a key with one fact, that of its first token.
[[nodiscard]] inline std::vector<Statement> states(fields::Field field, const Fact& fact = {}) {
  return {{std::move(field), {fact}}};
}

/// A program's name for a lens, and our model for it.
struct Lens {
  std::string_view name;   ///< "pinhole-radtan8"
  std::string_view model;  ///< "rational"
  /// An additional key next to the parameters that is no parameter of the model, and the number that a fresh file gets there;
  /// empty: no such key.
  std::string_view further = {};
  double none = 0.0;
};

/// A lens as two names and two lists of numbers: fx fy cx cy, and coefficients.
struct ListLens {
  std::string_view model;             ///< Our model's id. The first entry that can represent a camera is written.
  std::string_view camera_model;      ///< "pinhole"
  std::string_view distortion_model;  ///< "radial-tangential"
  std::span<const ParameterId> coefficients = {};
  std::size_t zeros = 0;                     ///< The number of zeros that follow the coefficients.
  std::span<const ParameterId> absent = {};  ///< Parameters of the model that are not in the list and must be 0.
  bool any_length = false;                   ///< The list may have any length, because the program ignores it.
  Code found = {};                           ///< A diagnostic for a file with these names. {0} camera, {1} and {2} the names
};

/// How a pose T_frame_camera is spelled: a translation [m] and a quaternion x y z w, under seven keys or as two lists.
struct PoseLayout {
  std::string_view frame;  ///< "imu0", "vehicle"
  FrameKind kind;
  std::span<const std::string_view> translation;  ///< Three keys, or the key of a list of three numbers.
  std::span<const std::string_view> rotation;     ///< Four keys, or the key of a list of four numbers.
  bool rotation_first = false;                    ///< In a fresh file the rotation comes before the translation.
  /// A quaternion with a length in this range is accepted and scaled to 1; others are an error.
  double shortest = 0.0;
  double longest = std::numeric_limits<double>::infinity();
  Code no_pose = {};    ///< The value is neither an object nor a list. {0} the pose
  Code length = {};     ///< The quaternion is not of unit length. {0} the pose, {1} the length
  Code no_length = {};  ///< Its length is 0. Arguments as for `length`.
  /// The matrix is not quite a rotation, and the nearest rotation is written. {2} the frame, {3} the difference
  Code restated = {};
  Code in_frame = {};  ///< Default value: the pose in another camera's frame. {0} that frame
  Code identity = {};  ///< Default value: the identity, as no pose is known.
  Code made_up = {};   ///< A sentence that contains either value as {0}; none: the value alone.
};

struct Key;

/// The keys of an object.
struct Mapping {
  std::span<const Key> keys;                       ///< The rows, in the order in which they are read.
  std::span<const std::string_view> written = {};  ///< The order of keys in a fresh file; empty: the order of `keys`.
  /// A prefix for the names of entries whose key no row has, which are kept as extra fields; nullopt: they are not kept.
  std::optional<std::string_view> unread = {};
  /// Duplicate keys get a warning, and only the entry that the dialect takes is kept as an extra field.
  bool warns_of_duplicates = false;
  bool stops_at_error = false;  ///< Reading ends at the first key that cannot be read.
  Code missing = {};            ///< A warning about all missing keys {0} that only the program {1} requires; none: no warning.
};

/// What follows if the key is missing: nothing, a warning or an error.
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

/// The data of a row's functions. Each function uses some of the members; the others stay empty.
struct Details {
  const Mapping* mapping = nullptr;  ///< The keys of an object.
  std::span<const Lens> lenses = {};
  std::span<const ListLens> list_lenses = {};
  const PoseLayout* pose = nullptr;
  std::optional<ParameterId> parameter = {};
  std::optional<double> Imu::*imu = nullptr;
  /// The key, in the same object, of the other half of the fact; for tuning(): the prefix of the extra field's key.
  std::string_view other = {};
  std::string_view list = {};   ///< The key, in the same object, of the lens's coefficients.
  std::string_view token = {};  ///< The value in a fresh file.
  std::size_t count = 0;        ///< The length of a list.
  double initial = 0.0;         ///< The program's initial value, for a fresh file.
  double per_second = 1.0;      ///< Units of a time in a second: 1e9 for nanoseconds.
  bool only_edited = false;     ///< A fresh file does not get this key.
  bool only_warns = false;      ///< The row only adds diagnostics; the value is kept as if no row had its key.
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
  Edit edit = nullptr;  ///< Null: an edit replaces the numbers that `write` spells differently before and after.
  bool inside = false;  ///< `write` returns the entries of the mapping under the key, not the key itself.
  Need need = Need::kOptional;
  Spread spread = Spread::kOnce;

  [[nodiscard]] std::string text() const { return std::string(name); }
};

/// The codes of a format's diagnostics.
struct Codes {
  Code wrong_syntax = {};       ///< The document is no mapping.
  Code missing = {};            ///< There is no {0}: {1}, a clause or empty. None: "missing-key" is used, as in other formats.
  Code missing_below = {};      ///< {0} has no {1}: {2}
  Code wrong = {};              ///< {0} is no mapping: {1}. None: no_object is used.
  Code unless_wanted = {};      ///< The clause {1} of the two above if a wanted key is missing.
  Code no_object = {};          ///< {0} is no mapping.
  Code no_camera_list = {};     ///< {0} is no list of cameras.
  Code no_list = {};            ///< {0} is no list of {1} items, one for each camera.
  Code item_count = {};         ///< {0} has {1} items, and there are {2} cameras.
  Code unknown_model = {};      ///< {0} has a model {1}.
  Code unknown_lens = {};       ///< {0} has a camera model {1} with a distortion model {2}.
  Code coefficient_count = {};  ///< {0} has {1} numbers; one of {2} is wanted of a distortion model {3}.
  Code not_four = {};           ///< {0} is {1}, and the matrix is 4 x 4.
  Code no_identity = {};        ///< {0}, the IMU's pose in the body, is not the identity.
  Code unknown_parameter = {};  ///< {0}'s {1} is no parameter of {2}.
  Code no_size = {};            ///< {0}'s value is no list of width and height.
  Code offset_not_whole = {};   ///< {0} is {1}, and a whole number is wanted.
  Code offset_invalid = {};     ///< {0}: {1}
  Code initial_value = {};      ///< Default value: {0}, the initial value of the program {1}.
  Code one_offset = {};         ///< There is one time offset for all cameras, a clause.
  Code offset_rounded = {};     ///< The time offset {2} is rounded to the file's unit.
  Code further_imu = {};        ///< {0} is lost: there is one IMU.
};

struct Schema {
  std::string_view what;  ///< The format's name in messages: "a Basalt calibration".
  text::Dialect dialect;
  Mapping root;
  Codes codes;
  std::string_view program = {};  ///< The program that reads the files, for messages about missing keys and initial values.
  bool one_camera = false;        ///< The document contains one camera, called "cam0" if it does not name it.
  std::string_view model = {};    ///< The model of that camera, if all files have the same one.
  bool numbers_in_lines = false;  ///< In a fresh file, each number of a list is on its own line.
};

/// The state while a rig is read.
struct Reading {
  const Schema& schema;
  fields::Reader& reader;
  const ReadOptions& options;
  Rig& rig;
  std::string owner;                    ///< The owner of the keys, for messages: "value0", "cam0 intrinsics".
  const text::Node* mapping = nullptr;  ///< The mapping that contains the key being read.
  Camera* camera = nullptr;             ///< The camera whose list item is being read; null outside of lists.
  Imu* imu = nullptr;                   ///< The IMU whose keys are being read; null: the only one.
  std::string_view lens = {};  ///< The name of the camera's lens in the file; empty before it is read, and if it is unknown.
  const ListLens* list_lens = nullptr;  ///< The lens, if it has two names; null before it is read.

  /// The value under a key as messages name it: "cam0 resolution" for a camera, otherwise the key.
  [[nodiscard]] std::string label(const Key& key) const {
    return ((camera != nullptr || imu != nullptr) && !owner.empty() ? owner + " " : "") + std::string(key.name);
  }
};

/// What a row writes: a rig, or one camera or IMU of it.
struct Subject {
  const Schema& schema;
  const Rig& rig;
  std::size_t camera = 0;
  std::size_t imu = 0;
  Written* fresh = nullptr;  ///< In a fresh file, receives the list of default values. Null in an edit.

  [[nodiscard]] const Camera& the_camera() const { return rig.cameras[camera]; }
};

/// A fresh YAML file, key by key. `head`: its first lines.
[[nodiscard]] std::optional<text::Document> composed_yaml(const Subject& subject, std::string head, std::string name,
                                                          Diagnostics& diagnostics);

/// The YAML lines of a mapping in a fresh file, with those of the mappings in it. `depth`: blanks before the first level;
/// `deeper`: additional blanks for each further level.
[[nodiscard]] std::string yaml_lines(const Subject& subject, const Mapping& mapping, std::size_t depth, std::size_t deeper);

/// Reads a document by the table; nullopt, with errors, if it contains no calibration.
[[nodiscard]] std::optional<Rig> read(const Schema& schema, std::span<const text::Document> documents,
                                      const ReadOptions& options, Diagnostics& diagnostics);
/// Reads the keys of one mapping of a document. False, with errors, if a key cannot be read.
[[nodiscard]] bool read_mapping(Reading& reading, const Mapping& mapping, const text::Node& node);
/// Keeps the entries of the mapping, and of those in it, that no row reads as extra fields of `owner`.
void keep_unread(Reading& reading, const Mapping& mapping, const text::Node& node, const std::string& owner);
/// The value under a key; null, with the diagnostic that its Need asks for, if it is missing.
[[nodiscard]] const text::Node* find_value(Reading& reading, const Key& key, const text::Node& mapping);

/// A fresh JSON file of a rig or, if schema.one_camera, of one camera. Each level is indented by two more blanks.
[[nodiscard]] std::string composed_json(const Schema& schema, const Rig& rig, std::size_t camera, Written& written);

/// True if both rigs have cameras with the same names in the same order. Only then can a file be edited.
[[nodiscard]] bool same_cameras(const Rig& old, const Rig& rig);
/// The document `base`, which contains `before`, with the numbers replaced that differ in `after`. Both rigs have the same
/// cameras.
[[nodiscard]] text::Document edited(const text::Document& base, const Subject& before, const Subject& after, Written& written);

/// Edits one mapping of a document, at any depth, like edited().
void edit(text::Document& document, const Mapping& mapping, const text::Node& node, const Subject& before, const Subject& after,
          Written& written);

/// The node that contains a fact of camera number `camera` (ignored for facts of the IMU); null if there is none.
[[nodiscard]] const text::Node* place_of(const Schema& schema, const text::Document& document, const Rig& rig,
                                         std::size_t camera, const Fact& fact);

/// True if the table has a key that writes facts of that kind.
[[nodiscard]] bool holds(const Schema& schema, FactKind kind);
/// Lists what the file rounds or has no key for: time offsets, topics, frame rates, IMUs, the baseline. `why`: a clause for the
/// messages.
void list_losses(const Schema& schema, const Rig& rig, const Message& why, std::vector<Loss>& losses);
/// The extra fields of the rig that a fresh file contains.
[[nodiscard]] std::vector<ExtraField> carried(const Schema& schema, const Rig& rig);

/// The keys of a mapping in the order of a fresh file.
[[nodiscard]] std::vector<const Key*> in_written_order(const Mapping& mapping);
[[nodiscard]] std::vector<fields::Field> fields_of(std::vector<Statement> statements);
/// The fields that a mapping's keys write, except those for facts of the kind `but`, sorted by key.
[[nodiscard]] std::vector<fields::Field> sorted_fields(const Subject& subject, const Mapping& mapping, FactKind but);

}  // namespace fca::schema
