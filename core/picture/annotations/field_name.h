// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_language.h"

#include <string>
#include <string_view>

namespace tetra {

struct ModelDescription;

/// What a model's values are called, for people: the array that it was built of, else the dataset.
std::string fieldName(const ModelDescription& description, const AnnotationLanguage& language);

/// A file's name without its folder and what stands behind the last point: what an array of it is called, or a picture.
std::string completeBaseName(std::string_view path);

} // namespace tetra
