// Chooses between trees and machines and between the formats.
// SPDX-License-Identifier: MIT
#include "runner/drawing/drawing.h"

#include "runner/drawing/machine_drawing.h"
#include "runner/drawing/machine_model.h"
#include "runner/drawing/tree_drawing.h"
#include "runner/drawing/tree_model.h"

namespace trellis {
namespace {

std::string draw_tree(const Document& document, DrawingFormat format,
                      const DrawingOptions& options) {
    const drawing::TreeModel model = drawing::tree_model(document, options);
    switch (format) {
    case DrawingFormat::svg: return drawing::tree_svg(document, model, options);
    case DrawingFormat::dot: return drawing::tree_dot(model, options);
    case DrawingFormat::text: return drawing::tree_text(model, options);
    }
    return {};
}

std::string draw_machine(const Document& document, DrawingFormat format,
                         const DrawingOptions& options) {
    const drawing::MachineModel model = drawing::machine_model(document);
    switch (format) {
    case DrawingFormat::svg: return drawing::machine_svg(document, model, options);
    case DrawingFormat::dot: return drawing::machine_dot(model, options);
    case DrawingFormat::text: return drawing::machine_text(model, options);
    }
    return {};
}

}  // namespace

std::string draw(const Document& document, DrawingFormat format, const DrawingOptions& options) {
    const std::optional<FileKind> kind = file_kind(document);
    if (!kind) return {};
    switch (*kind) {
    case FileKind::tree: return draw_tree(document, format, options);
    case FileKind::machine: return draw_machine(document, format, options);
    }
    return {};
}

}  // namespace trellis
