// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/hybrid/hybrid_renderer.h"

#include "plugins/api/boundary_parameters.h"
#include "plugins/renderers/hybrid/hybrid_session.h"

namespace tetra {
namespace {

constexpr const char* exact = Message::marked("exact").text;
constexpr const char* withCell = Message::marked("with-cell").text;

Parameter orderParameter()
{
    Parameter parameter;
    parameter.id = orderId;
    parameter.label = Message::marked("Order");
    parameter.explanation =
        Message::marked("How surfaces and volume are put in order: 'exact', or as the paper did 'with-cell', where "
                        "the part of a surface in a cell is drawn before the cell.");
    parameter.defaultValue = std::string(exact);
    parameter.choices = {exact, withCell};
    return parameter;
}

} // namespace

std::vector<Parameter> HybridRenderer::parameters(const FieldExtent& field) const
{
    return {transferParameter(field),   isovaluesParameter(field), shadedParameter(),
            orderParameter(),           boundaryParameter(),       boundaryOpacityParameter(),
            boundaryFarSideParameter(), clipParameter(),           outlineParameter()};
}

std::unique_ptr<RendererSession> HybridRenderer::open(std::shared_ptr<const TetrahedralMesh> mesh,
                                                      const Eigen::AlignedBox3d& bounds) const
{
    auto defaults = parameters(extentOf(*mesh, bounds));
    return std::make_unique<HybridSession>(std::move(mesh), bounds, std::move(defaults));
}

Result<HybridOrder> hybridOrderOf(const std::string& text)
{
    if (text == exact)
        return HybridOrder::Exact;
    if (text == withCell)
        return HybridOrder::WithCell;
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' is no order of surfaces and volume: it is exact or with-cell.", text)};
}

} // namespace tetra
