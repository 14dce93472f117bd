#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace mesher {

/// What a backend throws that cannot answer a question about the geometry of a model. Curves and surfaces are asked everywhere,
/// and none of the askers can go on without an answer: it ends the stage, and whoever runs stages makes an Error of it.
class GeometryFailure : public std::runtime_error
{
public:
    GeometryFailure(std::string entity, const std::string& reason)
        : std::runtime_error(reason), entity_(std::move(entity))
    {
    }

    /// What was asked, "Face3".
    [[nodiscard]] const std::string& entity() const { return entity_; }

private:
    std::string entity_;
};

}  // namespace mesher
