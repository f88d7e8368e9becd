// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/tan.h>

#include <iosfwd>

// The functions that the manuals in the headers show, as header_examples.cpp compiles them.
tetra::Result<int> halfOf(int number);
std::string versions();
tetra::Status countToHundred(std::stop_token stop, std::ostream& told);
double volumeOf(const tetra::TetrahedralMesh& mesh);
tetra::Result<tetra::Dataset> ball();
tetra::Result<std::string> built(const tetra::Dataset& dataset, const std::filesystem::path& output);
tetra::Result<tetra::BuildReport> builtSmall(const tetra::Dataset& dataset, const std::filesystem::path& output);
tetra::Result<std::string> describe(const std::filesystem::path& path);
tetra::Result<tetra::TetrahedralMesh> meshFrom(const std::string& place, double error);
tetra::Result<std::string> packed(const std::filesystem::path& model, const std::filesystem::path& output);
tetra::Status preview(const std::filesystem::path& packed, double error, const std::filesystem::path& output);
tetra::Result<std::shared_ptr<const tetra::ExtractedMesh>> meshOfOnePercent(std::shared_ptr<const tetra::Model> model);
tetra::Result<int> tetrahedraAtFirstSite(const tetra::Model& model);
tetra::Result<std::uint64_t> sizeOfOnePercent(const std::string& place);
tetra::MeshQuery ballInFocus(const Eigen::Vector3d& centre, double radius);
tetra::Result<std::string> proved(const tetra::Model& model, const tetra::Dataset& original);
tetra::Result<std::string> blueToYellow(double least, double largest, double thickness);
bool hasThickLines(const tetra::ParameterValues& chosen);
std::string viewOfBall(const tetra::Model& model, const tetra::Sphere& ball, double isovalue);
tetra::Result<std::shared_ptr<const tetra::ExtractedMesh>> meshInView(std::string_view text,
                                                                      std::shared_ptr<const tetra::Model> model);
tetra::Status pictureFromAbove(const std::filesystem::path& file, const std::string& mode,
                               const std::filesystem::path& target);
tetra::Status framesOf(tetra::PictureMaker& maker, const tetra::ViewValue& film, const std::filesystem::path& folder);
tetra::Result<tetra::Picture> look(std::shared_ptr<const tetra::TetrahedralMesh> mesh, double isovalue,
                                   const tetra::TransferFunction& function);
