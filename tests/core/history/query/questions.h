// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>
#include <tan/model.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace tetra {

using ModelPointer = std::shared_ptr<const Model>;
/// Gives an answer byte by byte, so that two can be compared.
using Question = std::function<Result<std::string>(const ModelPointer&)>;

/// Every kind of question that the library answers, about a model with this description. Those by insertion are
/// refused by models that allow none.
std::map<std::string, Question> questionsAbout(const ModelDescription& model);

/// Byte by byte.
std::string meshContent(const TetrahedralMesh& mesh);

} // namespace tetra
