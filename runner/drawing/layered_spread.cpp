// Across the layers: who stands how far to the right.
// SPDX-License-Identifier: MIT
#include "runner/drawing/layered_mesh.h"

#include <algorithm>
#include <limits>

namespace trellis::drawing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double box_gap = 34;   // between two boxes
constexpr double line_gap = 12;  // between a line and anything

double least_distance(const Vertex& left, const Vertex& right) {
    const double gap = left.passing || right.passing ? line_gap : box_gap;
    return left.right + gap + right.left;
}

/// Long lines first: what they pass is drawn around them.
double weight(const Vertex& a, const Vertex& b) {
    return a.passing && b.passing ? 8 : a.passing || b.passing ? 3 : 2;
}

class Spreader {
public:
    explicit Spreader(Mesh& mesh) : mesh_(mesh) {}

    void run() {
        for (const auto& layer : mesh_.layers)
            pull(layer, false, false);
        const int rounds = mesh_.vertices.size() < 50'000 ? 24 : 6;
        const std::size_t layers = mesh_.layers.size();
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < layers; ++i)
                pull(mesh_.layers[i], true, false);
            for (std::size_t i = layers; i-- > 0;)
                pull(mesh_.layers[i], false, true);
        }
        edge_of_.resize(mesh_.vertices.size(), none);
        means_.resize(mesh_.first_link.size());
        for (std::uint32_t edge = 0; edge + 1 < mesh_.first_link.size(); ++edge)
            for (std::uint32_t i = mesh_.first_link[edge]; i + 1 < mesh_.first_link[edge + 1]; ++i)
                edge_of_[mesh_.links[i].lower] = edge;
        for (int round = 0; round < rounds; ++round) {
            find_means();
            for (std::size_t i = 0; i < layers; ++i)
                pull(mesh_.layers[round % 2 == 0 ? i : layers - 1 - i], true, true);
        }
        for (std::size_t edge = 0; edge + 1 < mesh_.first_link.size(); ++edge)
            straighten(mesh_.first_link[edge], mesh_.first_link[edge + 1]);
        place_heading();
    }

private:
    /// Moves the vertices of a layer towards their neighbours above, below or both.
    void pull(const std::vector<std::uint32_t>& layer, bool from_above, bool from_below) {
        wishes_.clear();
        const std::size_t first = mesh_.vertices[layer.front()].heading ? 1 : 0;
        for (std::size_t i = first; i < layer.size(); ++i) {
            Wish wish = wish_of(layer[i], from_above, from_below);
            if (i > first)
                wish.gap = least_distance(mesh_.vertices[layer[i - 1]], mesh_.vertices[layer[i]]);
            wishes_.push_back(wish);
        }
        const std::vector<double> places = granted(wishes_, -infinity, infinity);
        for (std::size_t i = first; i < layer.size(); ++i)
            mesh_.vertices[layer[i]].x = places[i - first];
    }

    /// The heading stands over the left side of everything, or further left if that is taken.
    void place_heading() {
        double least = infinity;
        for (const Vertex& vertex : mesh_.vertices)
            if (!vertex.heading) least = std::min(least, vertex.x - vertex.left);
        for (const auto& layer : mesh_.layers) {
            Vertex& heading = mesh_.vertices[layer.front()];
            if (!heading.heading) continue;
            heading.x = least == infinity ? 0 : least + heading.left;
            if (layer.size() > 1) {
                const Vertex& next = mesh_.vertices[layer[1]];
                heading.x = std::min(heading.x, next.x - least_distance(heading, next));
            }
        }
    }

    /// The mean place of each edge between its ends: where all of it would like to be in the end.
    void find_means() {
        for (std::uint32_t edge = 0; edge + 1 < mesh_.first_link.size(); ++edge) {
            const std::uint32_t first = mesh_.first_link[edge],
                                last = mesh_.first_link[edge + 1] - 1;
            double sum = 0;
            for (std::uint32_t i = first; i < last; ++i)
                sum += mesh_.vertices[mesh_.links[i].lower].x;
            if (last > first) means_[edge] = sum / (last - first);
        }
    }

    Wish wish_of(std::uint32_t v, bool from_above, bool from_below) const {
        const Vertex& vertex = mesh_.vertices[v];
        double sum = 0, total = 0;
        const auto add = [&](const Vertex& other, double x) {
            const double w = weight(vertex, other);
            sum += w * x;
            total += w;
        };
        if (from_above)
            for (const std::uint32_t i : mesh_.above.of(v)) {
                const Link& link = mesh_.links[i];
                const Vertex& other = mesh_.vertices[link.upper];
                add(other, other.x + link.upper_x - link.lower_x);
            }
        if (from_below)
            for (const std::uint32_t i : mesh_.below.of(v)) {
                const Link& link = mesh_.links[i];
                const Vertex& other = mesh_.vertices[link.lower];
                add(other, other.x + link.lower_x - link.upper_x);
            }
        if (vertex.passing && !edge_of_.empty()) {
            constexpr double as_one = 16;  // outweighs the neighbours
            sum += as_one * means_[edge_of_[v]];
            total += as_one;
        }
        constexpr double indifferent = 0.05;  // stays where it is, but gives way
        return total > 0 ? Wish{sum / total, 0, total} : Wish{vertex.x, 0, indifferent};
    }

    /// Makes the longest possible pieces of one edge, links [first, last), exactly vertical.
    void straighten(std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = first; i + 1 < last;) {
            Room common{-infinity, infinity};
            double sum = 0;
            std::uint32_t end = i;
            for (; end + 1 < last; ++end) {
                const std::uint32_t v = mesh_.links[end].lower;
                const Room room = room_of(mesh_, v);
                const double least = std::max(common.least, room.least);
                const double most = std::min(common.most, room.most);
                if (end > i && least > most) break;
                common = {least, most};
                sum += mesh_.vertices[v].x;
            }
            const double mean = sum / (end - i);
            const double x = std::min(std::max(mean, common.least), common.most);
            for (; i < end; ++i)
                mesh_.vertices[mesh_.links[i].lower].x = x;
        }
    }

    static constexpr std::uint32_t none = 0xFFFFFFFF;

    Mesh& mesh_;
    std::vector<Wish> wishes_;
    std::vector<std::uint32_t> edge_of_;  // of passing vertices; empty until they pull together
    std::vector<double> means_;           // of each edge
};

}  // namespace

Room room_of(const Mesh& mesh, std::uint32_t v) {
    const Vertex& vertex = mesh.vertices[v];
    const auto& layer = mesh.layers[vertex.layer];
    Room room{-infinity, infinity};
    if (vertex.order > 0) {
        const Vertex& left = mesh.vertices[layer[vertex.order - 1]];
        room.least = left.x + least_distance(left, vertex);
    }
    if (vertex.order + 1 < layer.size()) {
        const Vertex& right = mesh.vertices[layer[vertex.order + 1]];
        room.most = right.x - least_distance(vertex, right);
    }
    return room;
}

void spread_layers(Mesh& mesh) {
    Spreader(mesh).run();
}

/// Without the gaps this is isotonic regression: pool adjacent violators.
std::vector<double> granted(const std::vector<Wish>& wishes, double least, double most) {
    struct Block {
        double sum;
        double weight;
        std::size_t size;
        double mean() const { return sum / weight; }
    };
    std::vector<Block> blocks;
    double shift = 0;
    for (const Wish& wish : wishes) {
        shift += wish.gap;
        blocks.push_back({(wish.at - shift) * wish.weight, wish.weight, 1});
        while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
            const Block last = blocks.back();
            blocks.pop_back();
            blocks.back().sum += last.sum;
            blocks.back().weight += last.weight;
            blocks.back().size += last.size;
        }
    }
    std::vector<double> places;
    places.reserve(wishes.size());
    const double furthest = std::max(least, most - shift);
    double gaps = 0;
    for (const Block& block : blocks) {
        const double at = std::min(std::max(block.mean(), least), furthest);
        for (std::size_t i = 0; i < block.size; ++i) {
            gaps += wishes[places.size()].gap;
            places.push_back(at + gaps);
        }
    }
    return places;
}

}  // namespace trellis::drawing
