// SPDX-License-Identifier: BSD-3-Clause
#include "camera_file.h"

#include "scaramuzza.h"

#include "../ocamcalib/inverse.h"
#include "../ocamcalib/ocamcalib.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/models/ocamcalib_parameters.h>

#include <algorithm>
#include <set>

namespace fca::vins {

using text::Node;

namespace {

constexpr std::string_view kHeadKeys[] = {"model_type", "camera_name", "image_width", "image_height"};

std::vector<std::string> types() {
  std::vector<std::string> result;
  for (const Layout& layout : layouts()) {
    if (std::ranges::find(result, layout.type) == result.end()) result.emplace_back(layout.type);
  }
  return result;
}

/// As camodocal's factory compares (boost::iequals).
bool same_in_any_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

/// "p3" -> 3; nothing of other keys.
std::optional<std::size_t> index_of(std::string_view key) {
  const std::optional<int> number = key.starts_with('p') ? text::parse_int(key.substr(1)) : std::nullopt;
  return number && *number >= 0 ? std::optional(static_cast<std::size_t>(*number)) : std::nullopt;
}

class CameraReader {
 public:
  CameraReader(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics)
      : document_(document), reader_(document, kDialect, diagnostics), options_(options) {}

  void read_into(Rig& rig) {
    if (!document_.source().bytes.starts_with("%YAML")) reader_.say(top(), Code::kYamlDirectiveMissing);
    reader_.warn_of_duplicates(document_.root());
    const Layout* layout = read_type();
    if (layout == nullptr) return;
    Camera camera;
    camera.name = "cam" + std::to_string(rig.cameras.size());
    const Node* name = reader_.find(document_.root(), "camera_name");
    std::string own = name != nullptr ? reader_.name(*name, "camera_name") : "";
    if (!own.empty() && own != kNameless) camera.name = std::move(own);
    camera.model = *make_model(layout->model);
    const bool sized = read_size(camera);
    const bool good = layout->type == kScaramuzza ? read_scaramuzza(camera, rig) : read_slots(*layout, camera);
    keep_unread(*layout, rig);
    reader_.warn_of_misspelt();
    if (sized && good) rig.cameras.push_back(std::move(camera));
  }

 private:
  /// The top of the file, for what it lacks.
  const Node& top() const { return document_.root().entries.front().key; }

  const Layout* read_type() {
    const Node* type = reader_.find(document_.root(), "model_type");
    if (type == nullptr) {
      reader_.say(top(), Code::kVinsTypeMissing, {types()});
      return nullptr;
    }
    const std::string name = type->value.substr(0, 40);
    if (same_in_any_case(name, kScaramuzza)) return layout_of_type(kScaramuzza);
    if (const Layout* layout = layout_of_type(name)) return layout;
    const auto meant =
        std::ranges::find_if(layouts(), [&name](const Layout& layout) { return same_in_any_case(layout.type, name); });
    if (meant != layouts().end()) {
      reader_.say(*type, Code::kVinsTypeMisspelt, {name, meant->type});
    } else {
      reader_.say(*type, Code::kVinsTypeUnknown, {name, types()});
    }
    return nullptr;
  }

  bool read_size(Camera& camera) {
    const Node* width = reader_.find(document_.root(), "image_width");
    const Node* height = reader_.find(document_.root(), "image_height");
    if (width != nullptr && height != nullptr) {
      camera.image_size = reader_.image_size(*width, *height, "image ");
    } else if (options_.image_size) {
      camera.image_size = options_.image_size;
    } else {
      std::vector<std::string> missing;
      if (width == nullptr) missing.emplace_back("image_width");
      if (height == nullptr) missing.emplace_back("image_height");
      reader_.say(top(), Code::kVinsSizeMissing, {missing});
    }
    return camera.image_size.has_value();
  }

  /// A mapping at the top; null with an error where it is missing or something else.
  const Node* section(std::string_view name) {
    if (const Node* known = known_section(name)) return known;
    const Node* node = reader_.find(document_.root(), name);
    if (node == nullptr) {
      reader_.say(top(), Code::kVinsSectionMissing, {name});
    } else {
      reader_.say(*node, Code::kVinsSectionNotAMapping, {name});
    }
    return nullptr;
  }
  const Node* known_section(std::string_view name) {
    const Node* node = reader_.find(document_.root(), name);
    return node != nullptr && node->is_mapping() ? node : nullptr;
  }

  /// An error where a section lacks keys; true where it has all.
  bool has_all(const Node& section, std::string_view name, std::span<const std::string> keys) {
    std::vector<std::string> missing;
    std::ranges::copy_if(keys, std::back_inserter(missing),
                         [&](const std::string& key) { return reader_.find(section, key) == nullptr; });
    if (missing.empty()) return true;
    SourceRange where = document_.range(section);
    where.length = 1;
    reader_.diagnostics().add(missing.size() > 1 ? Code::kVinsKeysMissing : Code::kVinsKeyMissing,
                              {name, missing, why_missing(missing.front())}, where);
    return false;
  }
  /// A clause, or none: Kannala-Brandt's coefficients have other names and another place than one expects.
  std::vector<Message> why_missing(const std::string& key) {
    const Node* type = reader_.find(document_.root(), "model_type");
    if (type->value != "KANNALA_BRANDT" || !key.starts_with('k')) return {};
    const Node* elsewhere = known_section("distortion_parameters");
    const bool is_there = elsewhere != nullptr && reader_.find(*elsewhere, key) != nullptr;
    return {Message{is_there ? Code::kVinsCoefficientsElsewhere : Code::kVinsCoefficientsByOtherNames}};
  }

  /// `owner`: whose parameters are known, a model_type or a clause.
  void warn_of_others(const Node& section, std::string_view name, const std::set<std::string_view>& known,
                      const Argument& owner) {
    reader_.warn_of_duplicates(section);
    for (const text::Entry& entry : section.entries) {
      if (!known.contains(entry.key.value))
        reader_.say(entry.key, Code::kVinsNoParameter, {name, entry.key.value.substr(0, 40), owner});
    }
  }

  bool read_slots(const Layout& layout, Camera& camera) {
    bool good = true;
    std::set<std::string_view> read;
    for (const Slot& first : layout.slots) {
      if (!read.insert(first.section).second) continue;
      const Node* node = section(first.section);
      good = node != nullptr && good;
      if (node == nullptr) continue;
      std::set<std::string_view> known;
      std::vector<std::string> keys;
      for (const Slot& slot : layout.slots) {
        if (slot.section != first.section) continue;
        known.insert(slot.key);
        keys.emplace_back(slot.key);
        const Node* value = reader_.find(*node, slot.key);
        const std::string what = std::string(slot.section) + " " + std::string(slot.key);
        good = value != nullptr && good;
        if (value != nullptr && slot.parameter) good = reader_.parameter(*value, what, *slot.parameter, camera.model) && good;
      }
      good = has_all(*node, first.section, keys) && good;
      warn_of_others(*node, first.section, known, layout.type);
    }
    if (!good) return false;
    const auto is_zero = [&camera](ParameterId id) { return parameter(camera.model, id).value() == 0.0; };
    const auto are_zero = [&is_zero](ParameterIds ids) { return std::ranges::all_of(ids, is_zero); };
    const bool none_of_four = layout.model != "kb4" && are_zero({"k1", "k2", "p1", "p2"});
    if (layout.model == "radtan" && none_of_four) {
      CameraModel straight = *make_model("pinhole");
      for (const ParameterId id : ParameterIds{"fx", "fy", "cx", "cy"})
        set_parameter(straight, id, parameter(camera.model, id).value());
      camera.model = straight;
    }
    if (layout.model == "rational" && none_of_four && !are_zero({"k3", "k4", "k5", "k6"}))
      reader_.say(*known_section("distortion_parameters"), Code::kVinsRationalIgnored);
    return true;
  }

  /// Sets a computed parameter, with errors at the number it was computed from; false without a number.
  bool set(const Node* node, std::string_view section, std::string_view key, ParameterId id, double value, Camera& camera) {
    return node != nullptr && reader_.parameter(*node, std::string(section) + " " + std::string(key), id, value, camera.model);
  }

  bool read_scaramuzza(Camera& camera, Rig& rig) {
    const Node* direct = section(kDirect);
    const Node* affine = section(kAffine);
    if (direct == nullptr || affine == nullptr) return false;
    Scaramuzza numbers;
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < kDirectCount; ++i) keys.push_back("p" + std::to_string(i));
    const std::vector<std::string> affine_keys = {"ac", "ad", "ae", "cx", "cy"};
    bool good = has_all(*direct, kDirect, keys);
    good = has_all(*affine, kAffine, affine_keys) && good;
    if (!good) return false;
    const auto read_real = [&](const Node& section, std::string_view name, std::string_view key, double& value) {
      const Node* node = reader_.find(section, key);
      const std::optional<double> read =
          node != nullptr ? reader_.real(*node, std::string(name) + " " + std::string(key)) : std::nullopt;
      good = good && read;
      value = read.value_or(value);
    };
    read_real(*affine, kAffine, "ac", numbers.ac);
    read_real(*affine, kAffine, "ad", numbers.ad);
    read_real(*affine, kAffine, "ae", numbers.ae);
    read_real(*affine, kAffine, "cx", numbers.cx);
    read_real(*affine, kAffine, "cy", numbers.cy);
    std::set<std::string_view> places;
    for (std::size_t i = 0; i < kDirectCount; ++i) {
      places.insert(keys[i]);
      read_real(*direct, kDirect, keys[i], numbers.direct.at(i));
    }
    warn_of_others(*direct, kDirect, places, Message{Code::kVinsPolynomial});
    warn_of_others(*affine, kAffine, {"ac", "ad", "ae", "cx", "cy"}, kScaramuzza);
    if (!good || !check(*direct, *affine, numbers)) return false;
    const CameraModel model = ocamcalib_of(numbers);
    const auto set_affine = [&](std::string_view key, ParameterId id) {
      good = set(reader_.find(*affine, key), kAffine, key, id, parameter(model, id).value(), camera) && good;
    };
    set_affine("ac", "c");
    set_affine("ad", "e");
    set_affine("ae", "d");
    set_affine("cx", "cx");
    set_affine("cy", "cy");
    for (std::size_t i = 0; i < kDirectCount; ++i) {
      const ParameterId id = kOcamcalibCoefficients.at(i);
      good = set(reader_.find(*direct, keys[i]), kDirect, keys[i], id, parameter(model, id).value(), camera) && good;
    }
    return good && read_inverse(camera, rig);
  }

  bool check(const Node& direct, const Node& affine, const Scaramuzza& numbers) {
    if (numbers.direct[0] > 0.0) {
      reader_.say(*reader_.find(direct, "p0"), Code::kVinsPolynomialSign);
      return false;
    }
    if (numbers.ac > 0.0 && numbers.ac > numbers.ad * numbers.ae) return true;
    reader_.say(*reader_.find(affine, "ac"), Code::kVinsAffineMirrors);
    return false;
  }

  bool read_inverse(const Camera& camera, Rig& rig) {
    const Node* node = known_section(kInverse);
    if (node != nullptr) {
      for (const text::Entry& entry : node->entries) {
        const std::optional<std::size_t> index = index_of(entry.key.value);
        if (!reader_.real(entry.value, std::string(kInverse) + " " + entry.key.value.substr(0, 40))) return false;
        if (index && *index < kInverseCount) continue;
        reader_.say(entry.key, Code::kVinsCoefficientIgnored, {kInverse, entry.key.value.substr(0, 40)});
      }
    }
    const std::vector<double> inverse = stated_inverse(document_);
    if (inverse.empty()) {
      reader_.say(top(), Code::kVinsInverseMissing);
      return true;
    }
    constexpr double kStalePx = 1.0;  // as for OCamCalib's own files
    const double error = ocamcalib::inverse_error(camera, inverse);
    if (error > kStalePx) reader_.say(*node, Code::kVinsInverseStale, {error});
    std::string listed;
    for (const double value : inverse) listed += (listed.empty() ? "" : " ") + text::format_real(value);
    rig.extra_fields.push_back(
        {camera.name, std::string(ocamcalib::kInverse), listed, {Code::kCalibResultsInverse, {inverse.size(), error, listed}}});
    return true;
  }

  void keep_unread(const Layout& layout, Rig& rig) {
    std::set<std::string_view> known(std::begin(kHeadKeys), std::end(kHeadKeys));
    for (const Slot& slot : layout.slots) known.insert(slot.section);
    if (layout.type == kScaramuzza) known.insert({kDirect, kInverse, kAffine});
    // VINS-Mono has the camera among the keys of its configuration.
    const bool configuration = reader_.find(document_.root(), "imu_topic") != nullptr;
    for (const text::Entry& entry : document_.root().entries) {
      if (known.contains(entry.key.value)) continue;
      const bool tuning = configuration && !entry.key.value.starts_with("extrinsic");
      rig.extra_fields.push_back({"", (tuning ? "vins." : "") + entry.key.value, fields::value_text(entry.value)});
    }
  }

  const text::Document& document_;
  fields::Reader reader_;
  const ReadOptions& options_;
};

}  // namespace

bool is_yaml(const text::Document& document) {
  const bool yaml = document.syntax() == text::Syntax::kYaml || document.syntax() == text::Syntax::kOpenCvYaml;
  return yaml && document.root().is_mapping() && !document.root().entries.empty();
}

void read_camera_file(const text::Document& document, const ReadOptions& options, Rig& rig, Diagnostics& diagnostics) {
  CameraReader(document, options, diagnostics).read_into(rig);
}

std::vector<double> stated_inverse(const text::Document& document) {
  const Node* section = text::find(document.root(), kInverse, kDialect);
  const Node* affine = text::find(document.root(), kAffine, kDialect);
  if (section == nullptr || affine == nullptr || !section->is_mapping()) return {};
  const Node* ac = text::find(*affine, "ac", kDialect);
  Scaramuzza numbers;
  numbers.ac = ac != nullptr ? text::parse_real(ac->value).value_or(1.0) : 1.0;
  for (std::size_t i = 0; i < kInverseCount; ++i) {
    const Node* value = text::find(*section, "p" + std::to_string(i), kDialect);
    if (value != nullptr) numbers.inverse.at(i) = text::parse_real(value->value).value_or(0.0);
  }
  return inverse_of(numbers);
}

}  // namespace fca::vins
