// SPDX-License-Identifier: BSD-3-Clause
// A format as a table: which fact of a rig stands under which key. One table reads files, composes fresh ones, edits them,
// finds the place of a fact and lists what the format cannot hold.
//
// A row (Key) is a pair of total functions: `read` takes a node's text to facts of the rig, `write` takes the rig to the text.
// keys.h makes the rows that formats share; what only one format has is a row with functions of its own, beside its table.
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
  kOther,  ///< What a rig has no member for: it is kept among its extra fields.
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

/// One number of a rig, but for the camera that it belongs to.
struct Fact {
  FactKind kind = FactKind::kOther;
  std::string_view parameter = {};            ///< kParameter: its name.
  std::optional<double> Imu::*imu = nullptr;  ///< kImu
  const PoseEdge* pose = nullptr;             ///< kPose: of the rig.
  int row = 0;  ///< kPose: an element of T_a_b; -1: any of its rotation. kImageSize: 0 width, 1 height.
  int column = 0;
  bool operator==(const Fact&) const = default;
};

/// A key, the tokens of its value, and the facts that they state, one for one. The first alone may be there.
struct Statement {
  fields::Field field;
  std::vector<Fact> facts = {};
};

/// Of a key whose first token stands for all.
[[nodiscard]] inline std::vector<Statement> states(fields::Field field, const Fact& fact = {}) {
  return {{std::move(field), {fact}}};
}

/// How a program's name for a lens and our model map onto each other.
struct Lens {
  std::string_view name;   ///< "pinhole-radtan8"
  std::string_view model;  ///< "rational"
  /// A key beside the parameters that the model has no parameter for, and what a fresh file says there; empty: none.
  std::string_view further = {};
  double none = 0.0;
};

/// A lens as two names and two lists of numbers: fx fy cx cy, and coefficients.
struct ListLens {
  std::string_view model;             ///< Ours. Written is the first row of a model that holds the camera.
  std::string_view camera_model;      ///< "pinhole"
  std::string_view distortion_model;  ///< "radial-tangential"
  std::span<const ParameterId> coefficients = {};
  std::size_t zeros = 0;                     ///< That follow the coefficients.
  std::span<const ParameterId> absent = {};  ///< Parameters that have no number here and must be 0.
  bool any_length = false;                   ///< The program reads no coefficients.
  Code found = {};                           ///< A finding about these names. {0} camera, {1} and {2} the names
};

/// Numbers of a pose T_frame_camera as a translation [m] and a quaternion x y z w: seven keys, or two lists.
struct PoseLayout {
  std::string_view frame;  ///< "imu0", "vehicle"
  FrameKind kind;
  std::span<const std::string_view> translation;  ///< Three keys, or that of a list of three.
  std::span<const std::string_view> rotation;     ///< Four keys, or that of a list of four.
  bool rotation_first = false;                    ///< In a fresh file.
  /// Lengths of a quaternion that are taken for a rotation's; others are an error.
  double shortest = 0.0;
  double longest = std::numeric_limits<double>::infinity();
  Code no_pose = {};    ///< Neither an object nor a list stands there. {0} the pose
  Code length = {};     ///< The quaternion is not of unit length. {0} the pose, {1} the length
  Code no_length = {};  ///< It is 0. The same.
  Code restated = {};   ///< A pose is only roughly a rotation and is written as the nearest. {2} the frame, {3} by how much
  Code in_frame = {};   ///< Made up: the pose in another camera. {0} which
  Code identity = {};   ///< Made up: no pose is known.
  Code made_up = {};    ///< Either, with more words: {0}. None: as it is.
};

struct Key;

/// An object of keys.
struct Mapping {
  std::span<const Key> keys;                       ///< In the order in which they are read.
  std::span<const std::string_view> written = {};  ///< Their order in a fresh file; empty: as above.
  /// What stands before the names of entries under other keys, which are kept as extra fields; nothing: they are not kept.
  std::optional<std::string_view> unread = {};
  bool warns_of_duplicates = false;  ///< And of entries that are kept only those that count.
  bool in_turn = false;              ///< No key is read after one that cannot be read.
  Code missing = {};                 ///< Said of all keys {0} without which only the program {1} stops; none: nothing is.
};

/// What a missing key is: nothing, a warning, an error.
enum class Need { kOptional, kWanted, kRequired };

/// Of how many cameras the value under a key speaks.
enum class Spread {
  kOnce,
  kCounted,   ///< A list with one item for each camera; its length is the number of cameras.
  kEach,      ///< A list with one item for each camera.
  kSomeEach,  ///< The same, and items may be missing.
  kNamed,     ///< A value for each camera, under the camera's own name.
  kNamedImu,  ///< The same for each IMU.
};

struct Reading;
struct Subject;

/// What the functions of a row need to know; the others stay empty.
struct Details {
  const Mapping* mapping = nullptr;  ///< The keys of an object.
  std::span<const Lens> lenses = {};
  std::span<const ListLens> list_lenses = {};
  const PoseLayout* pose = nullptr;
  std::optional<ParameterId> parameter = {};
  std::optional<double> Imu::*imu = nullptr;
  std::string_view other = {};  ///< The key beside it that states the other half of the fact; of tuning what its extra field
                                ///< has before the key.
  std::string_view list = {};   ///< The key beside it with a lens's coefficients.
  std::string_view token = {};  ///< What a fresh file says.
  std::size_t count = 0;        ///< Of the numbers of a list.
  double initial = 0.0;         ///< What the program starts from, for a fresh file.
  double per_second = 1.0;      ///< Units of a time in a second: 1e9 for nanoseconds.
  bool only_edited = false;     ///< A fresh file does not have it.
  bool only_warns = false;      ///< What stands there is kept as under a key that no row reads.
  bool real = false;            ///< A whole number is spelled with a point.
  bool of_imu = false;          ///< A text is the IMU's, and has quotes, needed or not.
};

/// A row of the table.
struct Key {
  using Read = bool (*)(Reading& reading, const Key& key, const text::Node& node);
  using Write = std::vector<Statement> (*)(const Subject& subject, const Key& key);
  using Edit = void (*)(text::Document& document, const text::Node& node, const Key& key, const Subject& before,
                        const Subject& after, Written& written);

  std::string_view name;
  FactKind fact = FactKind::kOther;
  Read read = nullptr;    ///< False, with an error said, where the node does not state the fact. Null: another row reads it.
  Write write = nullptr;  ///< Nothing where the rig does not state the fact: an edit then leaves what stands there.
  Details with = {};
  Edit edit = nullptr;  ///< Null: numbers of which `write` says another than before are replaced.
  bool inside = false;  ///< `write` gives the entries of the mapping that is the key's value, not the key itself.
  Need need = Need::kOptional;
  Spread spread = Spread::kOnce;

  [[nodiscard]] std::string text() const { return std::string(name); }
};

/// What a program's own sentences are called.
struct Codes {
  Code wrong_syntax = {};       ///< The document is no mapping.
  Code missing = {};            ///< There is no {0}: {1}, a clause or nothing. None: "missing-key" as everywhere.
  Code missing_below = {};      ///< {0} has no {1}: {2}
  Code wrong = {};              ///< {0} is no mapping: {1}. None: no_object.
  Code unless_wanted = {};      ///< What follows where a wanted key is not there: that clause.
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
  Code initial_value = {};      ///< Made up: {0}, what the program {1} starts from.
  Code one_offset = {};         ///< There is one time offset for all cameras, a clause.
  Code offset_rounded = {};     ///< The time offset {2} is rounded to the file's unit.
  Code further_imu = {};        ///< {0} is lost: there is one IMU.
};

struct Schema {
  std::string_view what;  ///< For people: "a Basalt calibration".
  text::Dialect dialect;
  Mapping root;
  Codes codes;
  std::string_view program = {};  ///< That reads it, for what is said of missing keys and initial values.
  bool one_camera = false;        ///< The document is a camera's, "cam0" if it does not name it.
  std::string_view model = {};    ///< Of that camera, where all are of one model.
  bool numbers_in_lines = false;  ///< A fresh file has each number of a list on a line of its own.
};

/// A rig while it is read.
struct Reading {
  const Schema& schema;
  fields::Reader& reader;
  const ReadOptions& options;
  Rig& rig;
  std::string owner;                    ///< What the keys belong to, for messages: "value0", "cam0 intrinsics".
  const text::Node* mapping = nullptr;  ///< That holds the key which is read.
  Camera* camera = nullptr;             ///< Whose item of a list is read; null outside.
  Imu* imu = nullptr;                   ///< Whose keys are read; null: those of the only one.
  std::string_view lens = {};  ///< The name of its lens as the file has it; empty before it is read, or where it is unknown.
  const ListLens* list_lens = nullptr;  ///< The same of one with two names.

  /// What a message calls the value under a key: "cam0 resolution" of a camera, else the key.
  [[nodiscard]] std::string label(const Key& key) const {
    return ((camera != nullptr || imu != nullptr) && !owner.empty() ? owner + " " : "") + std::string(key.name);
  }
};

/// What is written, or was read: a rig, or one camera or IMU of it.
struct Subject {
  const Schema& schema;
  const Rig& rig;
  std::size_t camera = 0;
  std::size_t imu = 0;
  Written* fresh = nullptr;  ///< A fresh file is composed: takes note of what is made up for it. Null in an edit.

  [[nodiscard]] const Camera& the_camera() const { return rig.cameras[camera]; }
};

/// A fresh YAML file, key by key, behind `head`: what stands in its first lines.
[[nodiscard]] std::optional<text::Document> composed_yaml(const Subject& subject, std::string head, std::string name,
                                                          Diagnostics& diagnostics);

/// The keys of a mapping and of those below it in a fresh YAML file, line by line: `depth` blanks before the first, `deeper`
/// more for each level.
[[nodiscard]] std::string yaml_lines(const Subject& subject, const Mapping& mapping, std::size_t depth, std::size_t deeper);

/// Reads documents by the table; nothing, with errors, where they hold no calibration.
[[nodiscard]] std::optional<Rig> read(const Schema& schema, std::span<const text::Document> documents,
                                      const ReadOptions& options, Diagnostics& diagnostics);
/// The keys of a mapping of a document that is read.
[[nodiscard]] bool read_mapping(Reading& reading, const Mapping& mapping, const text::Node& node);
/// Entries of the mapping, and of those below it, that no row reads: extra fields of `owner`.
void keep_unread(Reading& reading, const Mapping& mapping, const text::Node& node, const std::string& owner);
/// The value under a key; null where it is not there, and what is said then has been said.
[[nodiscard]] const text::Node* find_value(Reading& reading, const Key& key, const text::Node& mapping);

/// A fresh JSON file of a rig or (schema.one_camera) of one camera, two blanks deeper per level.
[[nodiscard]] std::string composed_json(const Schema& schema, const Rig& rig, std::size_t camera, Written& written);

/// Are the cameras of a file and of a rig the same ones, by their names and in that order? Then an edit can do.
[[nodiscard]] bool same_cameras(const Rig& old, const Rig& rig);
/// The base, which states `before`, with other numbers where `after` states others. The cameras are the same ones.
[[nodiscard]] text::Document edited(const text::Document& base, const Subject& before, const Subject& after, Written& written);

/// The same of one mapping of a document, which lies anywhere in it.
void edit(text::Document& document, const Mapping& mapping, const text::Node& node, const Subject& before, const Subject& after,
          Written& written);

/// The node that states a fact of a camera (`camera`: its index; any for facts of the IMU); null where none does.
[[nodiscard]] const text::Node* place_of(const Schema& schema, const text::Document& document, const Rig& rig,
                                         std::size_t camera, const Fact& fact);

/// Is there a key for facts of that kind?
[[nodiscard]] bool holds(const Schema& schema, FactKind kind);
/// What the file rounds or has no key for: time offsets, topics, frame rates, IMUs, the baseline. `why`: a clause.
void list_losses(const Schema& schema, const Rig& rig, const Message& why, std::vector<Loss>& losses);
/// Those of the rig's extra fields that a fresh file states.
[[nodiscard]] std::vector<ExtraField> carried(const Schema& schema, const Rig& rig);

/// The keys of a mapping in the order of a fresh file.
[[nodiscard]] std::vector<const Key*> in_written_order(const Mapping& mapping);
[[nodiscard]] std::vector<fields::Field> fields_of(std::vector<Statement> statements);
/// What the keys of a mapping, but for those of one kind, say of a subject: fields in the alphabet's order.
[[nodiscard]] std::vector<fields::Field> sorted_fields(const Subject& subject, const Mapping& mapping, FactKind but);

}  // namespace fca::schema
