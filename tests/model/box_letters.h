// A font for tests, which needs no fonts of the machine.
#pragma once

#include "model/painting/letters.h"

namespace suffuse {

/// Each character is half an em wide, and all but spaces are boxes of 0.4 × 0.7 ems in its middle. "fi" is a ligature.
/// Hebrew runs from the right to the left. Installed are "Boxes" with "Boxes Condensed", and "Crates".
class BoxLetters final : public LetterShaper {
public:
    static constexpr double advance = 0.5, left = 0.05, width = 0.4, height = 0.7;

    BoxLetters() { setLetterShaper(this); }
    ~BoxLetters() override { setLetterShaper(nullptr); }

    std::shared_ptr<const ShapedLine> shape(const QString &line, const Face &face) override
    {
        faces.push_back(face);
        auto out = std::make_shared<ShapedLine>();
        out->ascent = 0.8, out->descent = 0.2, out->xHeight = 0.5, out->underline = 0.1, out->lineThickness = 0.04;
        out->rightToLeft = line.isRightToLeft();
        for (qsizetype i = 0; i < line.size();) {
            const bool isPair = line[i].isHighSurrogate() && i + 1 < line.size();
            const bool isLigature = !face.isSpaced && line.mid(i, 2) == QLatin1String("fi");
            const qsizetype to = i + (isPair || isLigature ? 2 : 1);
            ShapedCluster cluster{i, to, 0, advance, 0, out->rightToLeft, line[i] == u' ' ? nullptr : box()};
            out->clusters.push_back(cluster);
            i = to;
        }
        const int count = int(out->clusters.size());
        for (int k = 0; k < count; ++k) {
            ShapedCluster &cluster = out->clusters[std::size_t(k)];
            cluster.visual = out->rightToLeft ? count - 1 - k : k;
            cluster.left = advance * cluster.visual;
        }
        out->width = advance * count;
        return out;
    }
    bool hasFamily(const QString &family) override
    {
        return family == "Boxes" || family == "Crates" || family == "Boxes Condensed";
    }
    QString familyFor(const QString &family) override { return hasFamily(family) ? family : QStringLiteral("Boxes"); }

    std::vector<Face> faces; ///< that were asked for

private:
    static std::shared_ptr<const LetterOutline> box()
    {
        const Point a{left, -height}, b{left + width, -height}, c{left + width, 0}, d{left, 0};
        const auto line = [](Point p, Point q) {
            return Cubic{{p, p + (1.0 / 3) * (q - p), q - (1.0 / 3) * (q - p), q}};
        };
        static const auto outline =
            std::make_shared<const LetterOutline>(LetterOutline{{line(a, b), line(b, c), line(c, d), line(d, a)}});
        return outline;
    }
};

} // namespace suffuse
