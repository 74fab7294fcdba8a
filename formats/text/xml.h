// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>

#include <optional>
#include <string>
#include <string_view>

namespace fca::text {

/// The key of an attribute.
[[nodiscard]] inline std::string attribute(std::string_view name) { return "@" + std::string(name); }

/// Parses the XML of cv::FileStorage with tinyxml2. The root node is what stands in <opencv_storage>.
///
/// An element's value: a mapping of its child elements; or a sequence of its texts and `<_>` elements, where blanks separate
/// texts and double quotes hold them together; one text alone is a scalar, none at all is null. Scalars span their text (with
/// its quotes), collections from the first '<' or text to the end of the last. type_id="opencv-matrix" is the tag that YAML
/// spells
/// !!opencv-matrix.
///
/// Or that of Metashape: the root is what stands in <calibration> or <document>, with that name as its tag, and an element's
/// attributes are entries before its own, under keys of attribute(); those of an element that holds text are not kept.
[[nodiscard]] std::optional<Node> parse_xml(const Source& source, Diagnostics& diagnostics);

}  // namespace fca::text
