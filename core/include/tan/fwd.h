// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/fwd.h: the names of what the other headers define, for headers that pass it on by reference or pointer and need
/// not read what it is.
///
/// ~~~{.cpp}
/// /// Does something with a mesh, elsewhere.
/// void useMesh(const tetra::TetrahedralMesh& mesh);
/// ~~~

namespace tetra {

// tan/base.h
struct Error;
class Message;
class Progress;
template <class Value> class Result;

// tan/data.h
struct Dataset;
struct Lattice;
class ScalarField;

// tan/mesh.h
struct TetrahedralMesh;
struct TriangleMesh;

// tan/model.h, tan/packed.h
class Model;
struct ModelDescription;
class PackedModel;

// tan/query.h
class ErrorField;
struct ExtractedMesh;
class MeshExtractor;
struct MeshQuery;

// tan/transfer.h
struct TransferFunction;

// tan/render.h
struct Camera;
struct Picture;
class RenderBackend;
struct Scene;

// tan/verify.h
struct VerificationReport;

// tan/view.h
struct ViewValue;

} // namespace tetra
