#pragma once

#include "brep/brep_model.h"

#include <cstdint>
#include <utility>

namespace mesher::test {

/// The solids of two models in one, that do not know of each other.
inline BrepModel together(BrepModel first, const BrepModel& second)
{
    const auto vertices = static_cast<std::uint32_t>(first.vertices.size());
    const auto edges = static_cast<std::uint32_t>(first.edges.size());
    const auto faces = static_cast<std::uint32_t>(first.faces.size());
    for (const BrepVertex& vertex : second.vertices) first.vertices.push_back(vertex);
    for (BrepEdge edge : second.edges) {
        edge.first.value += vertices;
        edge.last.value += vertices;
        first.edges.push_back(edge);
    }
    for (BrepFace face : second.faces) {
        for (BrepLoop& loop : face.loops) {
            for (BrepCoedge& coedge : loop.coedges) coedge.edge.value += edges;
        }
        first.faces.push_back(face);
    }
    for (BrepSolid solid : second.solids) {
        for (BrepShell& shell : solid.shells) {
            for (BrepShellFace& face : shell.faces) face.face.value += faces;
        }
        first.solids.push_back(solid);
    }
    first.box.include(second.box.low);
    first.box.include(second.box.high);
    return first;
}

/// The first solid of a model with that of another as a hollow in it.
inline BrepModel withHollow(BrepModel outer, const BrepModel& inner)
{
    const auto solids = static_cast<std::uint32_t>(outer.solids.size());
    BrepModel model = together(std::move(outer), inner);
    BrepShell hollow = model.solids[BrepSolidId(solids)].shells.front();
    for (BrepShellFace& face : hollow.faces) face.isReversed = !face.isReversed;
    model.solids.resize(solids);
    model.solids[BrepSolidId(0)].shells.push_back(hollow);
    return model;
}

}  // namespace mesher::test
