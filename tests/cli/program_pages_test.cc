// SPDX-License-Identifier: BSD-3-Clause
// The tables in the pages of programs (formats/programs) are made here: from the registry, and by asking the programs' readers
// what they do with a file from which a key is missing, or in which a number has another type. A comment above a table says
// what it is:
//   <!-- programs: orbslam3 orbslam2 -->         the readers, by their ids
//   <!-- models: orbslam3 -->                    of the format, or of several
//   <!-- keys: orbslam3 mono FILE; convert IN... -o ... -->   what the reader, in that mode ("-": it has none), does with FILE
// FCA_WRITE_GOLDEN=1 writes them.
#include "cli/run_program.h"

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/format.h>
#include <fca/formats/text/read_document.h>

#include <cmath>
#include <cstdlib>
#include <map>

namespace fca::test {
namespace {

const fs::path& pages_folder() {
  static const fs::path folder = fs::path(FCA_EXAMPLES_DIR).parent_path() / "formats/programs";
  return folder;
}

/// Names of the pages, "orbslam3.md".
std::set<std::string> pages() {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(pages_folder()))
    names.insert(entry.path().filename().string());
  names.erase("README.md");
  return names;
}

std::vector<std::string> words_in(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// --- What a reader sees

/// Rays up to 63 degrees from the axis.
std::vector<std::array<double, 3>> rays() {
  std::vector<std::array<double, 3>> result;
  for (const double x : {-1.4, -0.5, 0.0, 0.7, 1.3}) {
    for (const double y : {-1.3, -0.4, 0.0, 0.6, 1.4}) result.push_back({x, y, 1.0});
  }
  return result;
}

std::vector<double> numbers_of(const consumers::ConsumerView& view) {
  constexpr double kNone = -1e300;
  std::vector<double> numbers;
  for (const consumers::ConsumerCamera& camera : view.cameras) {
    numbers.insert(numbers.end(), {double(camera.width), double(camera.height), camera.time_offset_s.value_or(kNone)});
    for (const std::array<double, 3>& ray : rays()) {
      const auto pixel = camera.project(ray).value_or(std::array{kNone, kNone});
      numbers.insert(numbers.end(), pixel.begin(), pixel.end());
    }
  }
  for (const consumers::ConsumerPose& pose : view.poses) numbers.insert(numbers.end(), pose.T_a_b.begin(), pose.T_a_b.end());
  const consumers::ConsumerImu imu = view.imu.value_or(consumers::ConsumerImu());
  for (const std::optional<double>& number :
       {imu.gyroscope_noise_density, imu.gyroscope_random_walk, imu.accelerometer_noise_density, imu.accelerometer_random_walk,
        imu.rate_hz, view.baseline_m})
    numbers.push_back(number.value_or(kNone));
  return numbers;
}

/// A reader with what it is told, and the file that it is asked about.
struct Question {
  const consumers::Consumer* reader;
  consumers::LoadOptions options;
  text::Document file;

  [[nodiscard]] consumers::ConsumerView asked(const std::string& bytes) const { return reader->load(bytes, options); }
};

// --- A file's keys

struct Key {
  std::string path;           ///< "cam0/intrinsics"; a list's first mapping is "*"
  const text::Node* mapping;  ///< that holds it
  const text::Entry* entry;
};

bool is_matrix(const text::Node& node) {
  return std::ranges::any_of(node.entries, [](const text::Entry& entry) { return entry.key.value == "data"; });
}

void add_keys(const text::Node& node, const std::string& path, std::vector<Key>& keys) {
  if (node.is_sequence() && !node.items.empty()) add_keys(node.items.front(), path + "*/", keys);
  if (!node.is_mapping()) return;
  for (const text::Entry& entry : node.entries) {
    const std::string& name = entry.key.value;
    const bool holds_keys = (entry.value.is_mapping() && !is_matrix(entry.value)) ||
                            (entry.value.is_sequence() && !entry.value.items.empty() && entry.value.items.front().is_mapping());
    if (holds_keys) {
      add_keys(entry.value, path + name + "/", keys);
    } else {
      keys.push_back({path + name, &node, &entry});
    }
  }
}

/// Those of cameras after the first (cam1/...), but for what the first has, too.
void remove_repeated(std::vector<Key>& keys) {
  std::set<std::string> paths;
  for (const Key& key : keys) paths.insert(key.path);
  std::erase_if(keys, [&paths](const Key& key) {
    const bool is_later = key.path.starts_with("cam") && key.path.size() > 5 && key.path[4] == '/' && key.path[3] > '0';
    return is_later && paths.contains("cam0" + key.path.substr(4));
  });
}

enum class Kind { kInteger, kReal, kText, kBoolean };

Kind kind_of(const text::Node& scalar) {
  const std::string& text = scalar.value;
  if (!scalar.quoted && (text == "true" || text == "false")) return Kind::kBoolean;
  if (scalar.quoted || text.empty() || text.find_first_not_of("+-.0123456789eE") != std::string::npos) return Kind::kText;
  return text.find_first_of(".eE") == std::string::npos ? Kind::kInteger : Kind::kReal;
}

/// The value itself, or of a list or matrix the first whole number (whose value stays as it is), else the first one.
const text::Node& probe_of(const text::Node& node) {
  const auto data = std::ranges::find_if(node.entries, [](const text::Entry& entry) { return entry.key.value == "data"; });
  if (data != node.entries.end()) return probe_of(data->value);
  if (!node.is_sequence() || node.items.empty()) return node;
  for (const text::Node& item : node.items) {
    const text::Node& probe = probe_of(item);
    const double value = std::strtod(probe.value.c_str(), nullptr);
    if (kind_of(probe) < Kind::kText && value == std::round(value)) return probe;
  }
  return probe_of(node.items.front());
}

std::string type_of(const text::Node& value) {
  if (value.is_mapping()) return "matrix";
  constexpr std::array kNames = {"integer", "real", "text", "boolean"};
  const std::string name = kNames.at(static_cast<std::size_t>(kind_of(probe_of(value))));
  if (!value.is_sequence()) return name;
  return value.items.empty() ? "empty list" : value.items.front().is_sequence() ? "rows" : name + "s";
}

std::string without(const Question& question, const Key& key) {
  text::Document file = question.file;
  file.remove_entry(*key.mapping, *key.entry);
  const consumers::ConsumerView view = question.asked(file.bytes());
  if (!view.loads()) return "stops";
  return numbers_of(view) == numbers_of(question.asked(question.file.bytes())) ? "goes on" : "goes on, with another result";
}

/// What it makes of 20 for 20.0, or of 20.0 for 20.
std::string of_other_type(const Question& question, const Key& key) {
  const text::Node& scalar = probe_of(key.entry->value);
  const Kind kind = kind_of(scalar);
  if (kind == Kind::kText || kind == Kind::kBoolean) return "-";
  const double value = std::strtod(scalar.value.c_str(), nullptr);
  const bool is_small = value != 0.0 && std::abs(value) < 0.5;  // must not become 0
  const std::string whole = is_small ? "1" : std::to_string(std::lround(value));
  const auto with = [&](const std::string& number) {
    text::Document file = question.file;
    file.replace(scalar.span, number);
    return question.asked(file.bytes());
  };
  const consumers::ConsumerView as_is = with(kind == Kind::kReal ? whole + ".0" : whole);
  const consumers::ConsumerView other = with(kind == Kind::kReal ? whole : whole + ".0");
  if (!as_is.loads()) return "-";
  if (!other.loads()) return "stops";
  return numbers_of(as_is) == numbers_of(other) ? "reads it" : "reads another value";
}

// --- The tables

std::string table_of_programs(const std::vector<std::string>& ids) {
  std::string table = "| `--for` | program | reader written after |\n|---|---|---|\n";
  for (const std::string& id : ids) {
    const consumers::Consumer* reader = consumers::find_consumer(id);
    if (reader == nullptr) return "no program " + id + "\n";
    table += "| `" + id + "` | " + std::string(reader->program) + " | " + consumers::source_words(reader->source) + " |\n";
  }
  return table;
}

/// Of one format a row for each model, of several one for each format.
std::string table_of_models(const std::vector<std::string>& ids) {
  const bool one = ids.size() == 1;
  std::string table =
      one ? "| model | in the file | read by |\n|---|---|---|\n" : "| format | models (in the file) |\n|---|---|\n";
  for (const std::string& id : ids) {
    const Format* format = find_format(id);
    if (format == nullptr) return "no format " + id + "\n";
    std::string models;
    for (const StoredModel& stored : format->models) {
      const std::string model(stored.model);
      const std::string name(stored.file_name);
      if (one) table += "| " + model + " | " + name + " | " + std::string(stored.read_by) + " |\n";
      models += (models.empty() ? "" : ", ") + model + " (" + name + ")";
    }
    if (!one) table += "| `" + id + "` | " + models + " |\n";
  }
  return table;
}

std::string table_of_keys(const std::vector<std::string>& words) {
  const consumers::Consumer* reader = consumers::find_consumer(words.at(0));
  if (reader == nullptr) return "no program " + words.at(0) + "\n";
  const std::string name = words.at(2).substr(0, words.at(2).find(';'));
  const TemporaryFolder folder;
  for (const char* input : {"tumvi/camchain.yaml", "tumvi/imu.yaml", "tumvi/ds.yaml", "vins_config.yaml"})
    fs::copy(fs::path(FCA_EXAMPLES_DIR) / input, folder.path());
  const RunResult run = run_program({words.begin() + 3, words.end()}, {.folder = folder.path().string()});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const std::string bytes = read_file(folder.path() / name);
  Diagnostics diagnostics;
  std::optional<text::Document> file = text::parse_document({name, bytes}, diagnostics);
  if (!file) return "unread\n";
  Question question{reader, {.file_name = fs::path(name).filename().string(), .image_size = {512.0, 512.0}}, *std::move(file)};
  if (words.at(1) != "-") question.options.sensor = words.at(1);
  if (reader->prepare != nullptr) reader->prepare();
  EXPECT_TRUE(question.asked(bytes).loads());

  std::vector<Key> keys;
  add_keys(question.file.root(), "", keys);
  remove_repeated(keys);
  std::vector<std::string> rows;  // in the order of their first keys
  std::map<std::string, std::string> names;
  std::map<std::string, std::string> shown;  // the place of the last key in a row: of others in it the names alone are listed
  for (const Key& key : keys) {
    const std::string row = type_of(key.entry->value) + " | " + without(question, key) + " | " + of_other_type(question, key);
    if (!names.contains(row)) rows.push_back(row);
    const std::size_t end = key.path.find_last_of("/.") + 1;  // 0: at the top
    const bool is_beside = end > 0 && shown[row] == key.path.substr(0, end);
    shown[row] = key.path.substr(0, end);
    names[row] += (names[row].empty() ? "`" : ", `") + (is_beside ? key.path.substr(end) : key.path) + "`";
  }
  std::string table = "| keys | type | without it | of the other number type |\n|---|---|---|---|\n";
  for (const std::string& row : rows) table += "| " + names[row] + " | " + row + " |\n";
  return table;
}

/// The page with its tables made again.
std::string with_tables(const std::string& page) {
  const std::map<std::string, std::string (*)(const std::vector<std::string>&)> kTables = {
      {"programs:", &table_of_programs}, {"models:", &table_of_models}, {"keys:", &table_of_keys}};
  std::string result;
  bool old = false;  // the table that was there
  for (const std::string& line : lines_of(page)) {
    if (old && line.starts_with('|')) continue;
    old = false;
    result += line + "\n";
    std::vector<std::string> words = words_in(line);
    if (words.size() < 4 || words.front() != "<!--" || !kTables.contains(words[1])) continue;
    old = true;
    result += kTables.at(words[1])({words.begin() + 2, words.end() - 1});
  }
  return result;
}

class ProgramPages : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, ProgramPages, testing::ValuesIn(pages()), [](const auto& page) {
  std::string name = page.param.substr(0, page.param.find('.'));
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST_P(ProgramPages, HaveTheTablesOfTheirReaders) {
  const fs::path path = pages_folder() / GetParam();
  const std::string page = read_file(path);
  const std::string made = with_tables(page);
  if (std::getenv("FCA_WRITE_GOLDEN") != nullptr) {
    std::ofstream(path, std::ios::binary) << made;
    return;
  }
  EXPECT_EQ(page, made);
  EXPECT_LE(lines_of(page).size(), 90U);
}

// Each program that fca-io imitates has a page, and the list of pages names them all.
TEST(ProgramPagesList, HasEveryProgram) {
  std::set<std::string> shown;
  const std::string list = read_file(pages_folder() / "README.md");
  for (const std::string& name : pages()) {
    EXPECT_TRUE(contains(list, "](" + name + ")")) << name;
    for (const std::string& line : lines_of(read_file(pages_folder() / name))) {
      const std::vector<std::string> words = words_in(line);
      if (words.size() > 3 && words[1] == "programs:") shown.insert(words.begin() + 2, words.end() - 1);
    }
  }
  for (const consumers::Consumer& reader : consumers::all_consumers())
    EXPECT_TRUE(shown.contains(std::string(reader.id))) << "no page for " << reader.id;
}

}  // namespace
}  // namespace fca::test
