// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json.h"

#include <tan/data.h>
#include <tan/model.h>
#include <tan/render.h>
#include <tan/view.h>

#include <Eigen/Geometry>

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// What is open and how it is seen, as a file keeps it: a JSON text of the format "tan-session", version 1. Models are
/// named by two paths, relative to the session's folder and absolute, so that either can be moved; sessionModel() tells
/// where the model is.
struct SessionDocument {
    std::filesystem::path model; ///< absolute, as earlier programs read it
    std::filesystem::path
        relativeModel{}; ///< by its path from the session's folder, absolute; empty if that is `model`
    std::filesystem::path absoluteModel{}; ///< where it lay when the file was written; likewise
    std::uint64_t identity = 0;            ///< modelIdentity() of the model; 0 if the file does not say
    Eigen::AlignedBox3d bounds{};          ///< of the model; empty if the file does not say
    bool withDirections = false;           ///< its places are those of a lattice that does not lie along the axes
    std::optional<ValueRange> range{};     ///< of its values; nothing if the file does not say
    std::string valueName{};               ///< what its values are called (ModelDescription); empty: not known
    ViewValue view{};
    bool hasCamera = false; ///< else the view's is none that anybody chose
    /// Of the view, width and height in pixels: lines and texts take as much of a picture as they do of that. Zeros if
    /// the file does not say.
    std::array<int, 2> viewSize{};
    std::filesystem::path file{}; ///< of a session that was kept before it was saved: where it belongs; else empty
    JsonObject found{};           ///< the whole text that was read: what is not known here stays in it
};

inline constexpr const char* sessionSuffix = "tansession";

/// Of modelIdentity() in a model's file.
inline constexpr std::size_t headerChecksumOffset = 248;

/// Differs for models of different content: the checksum of the header and the section table (FORMAT.md).
std::uint64_t modelIdentity(const Model& model);

/// Of a view of this model, which is as it was chosen to be.
SessionDocument documentOf(const Model& model, const ViewValue& view);

/// Whether the document seems to be of the same lattice without its directions, as TAn read such data up to version
/// 0.1: of a box that is as long along x, y and z as the lattice is along its own axes.
bool lacksDirections(const SessionDocument& document, const Model& model);

/// Whether places, or values, of the document are places, or values, of this model, too: it is the same one, or has the
/// same domain, or the same range; or the document does not say.
bool isOfSameDomain(const SessionDocument& document, const Model& model);
bool isOfSameRange(const SessionDocument& document, const Model& model);
/// Whether its values are called otherwise than this model's: another array, say.
bool isOfOtherValues(const SessionDocument& document, const Model& model);

/// Whether the file's name is that of a session.
bool isSessionFile(const std::filesystem::path& path);

std::string sessionToText(const SessionDocument& document, const std::filesystem::path& folder);

/// What the text leaves open is as `SessionDocument` has it, a focus of no shape and so on. Errors name the key.
Result<SessionDocument> sessionFromText(std::string_view text, const std::filesystem::path& folder);

/// What a PNG file says of how it was made, by keywords: "Software", "Title", "Description" with the accuracy, and in
/// "TAn-session" the session in our JSON, by which the picture can be made again.
std::map<std::string, std::string> pictureTexts(const SessionDocument& document, const std::string& accuracy,
                                                const std::filesystem::path& folder);

/// The session that a PNG file holds; empty if it holds none or is not a PNG file. Reads no pixels. Errors: a file that
/// cannot be opened, and what is not a regular file.
Result<std::string> sessionInPicture(const std::filesystem::path& path);

/// Whether the file's name is that of a PNG picture.
bool isPictureFile(const std::filesystem::path& path);

/// Reads a session from a file of its own or from a picture that holds one. Errors name the file.
Result<SessionDocument> readSession(const std::filesystem::path& path);

} // namespace tetra
