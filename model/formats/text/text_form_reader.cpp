// Reads the text form (docs/text-form.md).
#include "model/formats/files.h"
#include "model/formats/messages.h"
#include "model/formats/text/field_json.h"
#include "model/painting/validate.h"

namespace suffuse {

namespace {

using Names = std::string_view;

/// The greatest version that is read.
constexpr int textFormVersion = 5;

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
        if (const int needed = versionNeededBy(m_painting); needed > m_version)
            return fileError(m_fileName, FileMessages::tr("version: %1 does not know all that strokes have here; "
                                                          "write %2")
                                             .arg(m_version)
                                             .arg(needed));
        if (const QString problem = problemOf(m_painting); !problem.isEmpty())
            return fileError(m_fileName, problem);
        forgetLostCurves(m_painting);
        return std::move(m_painting);
    }

private:
    void stroke(Stroke &s)
    {
        const bool hasId = readObject(m_json, s) & field_json::namesOf<Stroke>.bitOf("id");
        if (m_json.ok() && hasId && s.id == 0)
            m_json.failMember("id", FileMessages::tr("0 is not an id; count from 1 or leave it out"));
        s.segments.shrink_to_fit();
    }

    void underlay()
    {
        auto u = std::make_shared<Underlay>();
        readObject(m_json, *u);
        if (m_json.ok() && !share.contains(u->opacity))
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
        if (m_json.ok() && value > textFormVersion)
            m_json.fail(FileMessages::tr("%1 is newer than this program, which reads up to version %2; update Suffuse")
                            .arg(value)
                            .arg(textFormVersion));
        m_version = int(std::min<std::uint64_t>(value, textFormVersion));
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
                readObject(m_json, m_painting.canvas);
                return;
            case 3:
                m_json.array([&](std::size_t) {
                    auto s = std::make_shared<Stroke>();
                    stroke(*s);
                    m_painting.strokes.push_back(std::move(s));
                });
                return;
            case 4:
                m_json.array([&](std::size_t) { readObject(m_json, m_painting.groups.emplace_back()); });
                return;
            case 5:
                m_json.array([&](std::size_t) { readObject(m_json, m_painting.swatches.emplace_back()); });
                return;
            default:
                return underlay();
            }
        });
        requireMembers(m_json, found, names, memberBit(0) | memberBit(1) | memberBit(3));
    }

    /// Gives strokes without an id the ids after the greatest one.
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
    int m_version = 1;
    Painting m_painting;
};

} // namespace

Result<Painting> readTextForm(const QByteArray &bytes, const QString &fileName)
{
    return TextFormReader(bytes, fileName).read();
}

} // namespace suffuse
