// docs/text-form.md, reading.
#include "model/formats/embedded_image.h"
#include "model/formats/files.h"
#include "model/formats/messages.h"
#include "model/formats/text/value_json.h"
#include "model/painting/validate.h"

namespace suffuse {

namespace {

using Names = std::string_view;

/// Members that must be there, as bits of the name tables below.
constexpr auto bit = memberBit;

class TextFormReader {
public:
    TextFormReader(const QByteArray &bytes, const QString &fileName) : m_json(bytes, fileName), m_fileName(fileName) {}

    Result<Painting> read()
    {
        document();
        m_json.finish();
        if (!m_json.ok())
            return Error{m_json.error()};
        giveIds();
        if (const QString problem = problemOf(m_painting); !problem.isEmpty())
            return fileError(m_fileName, problem);
        return std::move(m_painting);
    }

private:
    void require(std::uint32_t found, std::span<const Names> names, std::uint32_t wanted)
    {
        requireMembers(m_json, found, names, wanted);
    }

    int choice(std::span<const Names> words) { return readChoice(m_json, words); }

    void bezier(std::array<Offset, 4> &points)
    {
        const std::size_t count = m_json.array([&](std::size_t i) {
            std::array<float, 2> xy{};
            m_json.readAll(xy);
            if (i < 4)
                points[i] = {xy[0], xy[1]};
        });
        if (m_json.ok() && count != 4)
            m_json.fail(FileMessages::tr("has %1 points instead of 4").arg(count));
    }

    void anisotropy(Segment &s)
    {
        static constexpr Names names[] = {"ratio", "angle"};
        m_json.object(names, [&](int k) { m_json.read(k == 0 ? s.anisotropyRatio : s.anisotropyAngle); });
    }

    void rewet(std::vector<Rewet> &list)
    {
        m_json.array([&](std::size_t) {
            Rewet r;
            const std::size_t count = m_json.array([&](std::size_t i) {
                Microseconds ignored = 0;
                m_json.readSeconds(i == 0 ? r.time : i == 1 ? r.extra : ignored);
            });
            if (m_json.ok() && count != 2)
                m_json.fail(FileMessages::tr("has %1 numbers instead of 2").arg(count));
            list.push_back(r);
        });
    }

    void segment(Segment &s)
    {
        static constexpr Names names[] = {"bezier", "diffusion", "density", "granulation", "maxAge", "born",
                                          "colour", "style",     "node",    "anisotropy",  "rewet"};
        static constexpr Names nodes[] = {"smooth", "symmetric", "corner"};
        const auto found = m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                return bezier(s.bezier);
            case 1:
                return m_json.read(s.diffusion);
            case 2:
                return m_json.read(s.density);
            case 3:
                return m_json.read(s.granulation);
            case 4:
                return m_json.read(s.maxAge);
            case 5:
                return m_json.readSeconds(s.born);
            case 6:
                return readJson(m_json, s.colour);
            case 7:
                return readJson(m_json, s.style.emplace());
            case 8:
                s.node = NodeKind(choice(nodes));
                return;
            case 9:
                return anisotropy(s);
            default:
                return rewet(s.rewet);
            }
        });
        require(found, names, bit(0) | bit(1) | bit(2));
    }

    void idOrNull(std::uint64_t &id)
    {
        if (!m_json.skipNull())
            m_json.read(id);
    }

    void stroke(Stroke &s)
    {
        static constexpr Names names[] = {"id",    "name", "group",  "visible", "locked",
                                          "style", "mix",  "origin", "brush",   "segments"};
        const auto found = m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                return m_json.read(s.id);
            case 1:
                return m_json.read(s.name);
            case 2:
                return idOrNull(s.group);
            case 3:
                return m_json.read(s.visible);
            case 4:
                return m_json.read(s.locked);
            case 5:
                return readJson(m_json, s.style);
            case 6:
                return readJson(m_json, s.mix);
            case 7: {
                std::array<double, 2> xy{};
                m_json.readAll(xy);
                s.origin = {xy[0], xy[1]};
                return;
            }
            case 8:
                return m_json.read(s.brush);
            default:
                m_json.array([&](std::size_t) { segment(s.segments.emplace_back()); });
            }
        });
        require(found, names, bit(9));
        if (m_json.ok() && (found & bit(0)) && s.id == 0)
            m_json.failMember("id", FileMessages::tr("0 is not an id; count from 1 or leave it out"));
        s.segments.shrink_to_fit();
    }

    void image(EncodedImage &target)
    {
        QString text;
        m_json.read(text);
        if (!m_json.ok())
            return;
        auto image = imageFromText(text, m_fileName);
        if (image)
            target = *image;
        else
            m_json.fail(image.error());
    }

    void paper(Paper &p)
    {
        static constexpr Names names[] = {"kind", "seed", "scale", "strength", "image", "grain"};
        static constexpr Names kinds[] = {"none", "procedural", "image"};
        static constexpr Names grains[] = {"tooth", "fibres", "weave"};
        const auto found = m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                p.kind = PaperKind(choice(kinds));
                return;
            case 1: {
                std::uint64_t seed = 0;
                m_json.read(seed);
                if (m_json.ok() && seed > 0xffffffffu)
                    m_json.fail(FileMessages::tr("%1 is not in [0, 4294967295]").arg(seed));
                p.seed = std::uint32_t(seed);
                return;
            }
            case 2:
                return m_json.read(p.scale);
            case 3:
                return m_json.read(p.strength);
            case 4:
                return image(p.image);
            default:
                p.grain = PaperGrain(choice(grains));
            }
        });
        require(found, names, p.kind == PaperKind::Image ? bit(0) | bit(4) : bit(0));
    }

    void canvas(Canvas &c)
    {
        static constexpr Names names[] = {"width", "height", "background", "paper"};
        m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                return m_json.read(c.width);
            case 1:
                return m_json.read(c.height);
            case 2:
                return readJson(m_json, c.background);
            default:
                return paper(c.paper);
            }
        });
    }

    void group(Group &g)
    {
        static constexpr Names names[] = {"id", "name", "parent", "visible", "locked"};
        const auto found = m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                return m_json.read(g.id);
            case 1:
                return m_json.read(g.name);
            case 2:
                return idOrNull(g.parent);
            case 3:
                return m_json.read(g.visible);
            default:
                return m_json.read(g.locked);
            }
        });
        require(found, names, bit(0));
    }

    void swatch(Swatch &s)
    {
        static constexpr Names names[] = {"name", "colour"};
        const auto found = m_json.object(names, [&](int k) { k == 0 ? m_json.read(s.name) : readJson(m_json, s.colour); });
        require(found, names, bit(1));
    }

    void underlay()
    {
        static constexpr Names names[] = {"image", "area", "opacity", "visible"};
        auto u = std::make_shared<Underlay>();
        const auto found = m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                return image(u->image);
            case 1: {
                std::array<double, 4> area{};
                m_json.readAll(area);
                if (m_json.ok() && !(area[2] >= 0 && area[3] >= 0))
                    m_json.fail(FileMessages::tr("width and height must not be negative"));
                u->area = Rect::of(area[0], area[1], area[2], area[3]);
                return;
            }
            case 2:
                return m_json.read(u->opacity);
            default:
                return m_json.read(u->visible);
            }
        });
        require(found, names, bit(0) | bit(1));
        if (m_json.ok() && !(u->opacity >= 0 && u->opacity <= 1))
            m_json.failMember("opacity", FileMessages::tr("%1 is not in [0, 1]").arg(double(u->opacity)));
        m_painting.underlay = std::move(u);
    }

    void format()
    {
        QString text;
        m_json.read(text);
        if (m_json.ok() && text != QLatin1String("suffuse-text"))
            m_json.fail(FileMessages::tr("“%1” is not “suffuse-text”").arg(excerpt(text.toStdString())));
    }

    void version()
    {
        std::uint64_t value = 0;
        m_json.read(value);
        if (m_json.ok() && value == 0)
            m_json.fail(FileMessages::tr("0 is not a version; write 1"));
        if (m_json.ok() && value > 1)
            m_json.fail(
                FileMessages::tr("%1 is newer than this program, which reads version 1; update Suffuse").arg(value));
    }

    void document()
    {
        static constexpr Names names[] = {"format", "version", "canvas", "strokes", "groups", "swatches", "underlay"};
        const auto found = m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                return format();
            case 1:
                return version();
            case 2:
                return canvas(m_painting.canvas);
            case 3:
                m_json.array([&](std::size_t) {
                    auto s = std::make_shared<Stroke>();
                    stroke(*s);
                    m_painting.strokes.push_back(std::move(s));
                });
                return;
            case 4:
                m_json.array([&](std::size_t) { group(m_painting.groups.emplace_back()); });
                return;
            case 5:
                m_json.array([&](std::size_t) { swatch(m_painting.swatches.emplace_back()); });
                return;
            default:
                return underlay();
            }
        });
        require(found, names, bit(0) | bit(1) | bit(3));
    }

    /// Strokes without an id take the ids after the greatest one.
    void giveIds()
    {
        StrokeId next = 0;
        for (const StrokePtr &s : m_painting.strokes)
            next = std::max(next, s->id);
        for (StrokePtr &s : m_painting.strokes) {
            if (s->id != 0)
                continue;
            auto named = std::make_shared<Stroke>(*s);
            named->id = ++next;
            s = std::move(named);
        }
    }

    JsonReader m_json;
    QString m_fileName;
    Painting m_painting;
};

} // namespace

Result<Painting> readTextForm(const QByteArray &bytes, const QString &fileName)
{
    return TextFormReader(bytes, fileName).read();
}

} // namespace suffuse
