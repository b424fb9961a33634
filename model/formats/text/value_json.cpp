#include "model/formats/text/value_json.h"

#include "model/formats/messages.h"
#include "model/formats/text/text_numbers.h"
#include "model/painting/fields.h"

namespace suffuse {

namespace {

using Names = std::string_view;

} // namespace

void requireMembers(JsonReader &json, std::uint32_t found, std::span<const Names> names, std::uint32_t wanted)
{
    for (std::size_t k = 0; json.ok() && k < names.size(); ++k) {
        if ((wanted & memberBit(int(k))) && !(found & memberBit(int(k))))
            json.failMember(names[k], FileMessages::tr("is missing"));
    }
}

int readChoice(JsonReader &json, std::span<const Names> words)
{
    QString text;
    json.read(text);
    if (!json.ok())
        return 0;
    QString list;
    for (std::size_t k = 0; k < words.size(); ++k) {
        const auto word = QLatin1String(words[k].data(), qsizetype(words[k].size()));
        if (text == word)
            return int(k);
        list += (k ? QStringLiteral(", ") : QString()) + word;
    }
    json.fail(FileMessages::tr("“%1” is none of: %2").arg(excerpt(text.toStdString()), list));
    return 0;
}

void readJson(JsonReader &json, Colour &c)
{
    std::array<float, 4> values{};
    json.readAll(values);
    c = {values[0], values[1], values[2], values[3]};
}

void readJson(JsonReader &json, Style &s)
{
    static constexpr Names names[] = {"kind", "xi"};
    static constexpr auto &kinds = WordsOf<StyleKind>::list;
    std::size_t given = 0;
    s.xi = {0, 0, 0};
    const auto found = json.object(names, [&](int k) {
        if (k == 0) {
            s.kind = StyleKind(readChoice(json, kinds));
        } else {
            given = json.array([&](std::size_t i) {
                float ignored = 0;
                json.read(i < 3 ? s.xi[i] : ignored);
            });
        }
    });
    requireMembers(json, found, names, memberBit(0) | memberBit(1));
    const auto wanted = std::size_t(xiCount(s.kind));
    if (json.ok() && given != wanted)
        json.failMember("xi", FileMessages::tr("has %1 numbers; the kind %2 has %3")
                                  .arg(given)
                                  .arg(QLatin1String(kinds[int(s.kind)].data()))
                                  .arg(wanted));
}

void readJson(JsonReader &json, Mix &m)
{
    static constexpr Names names[] = {"mode", "beta"};
    const auto found = json.object(names, [&](int k) {
        if (k == 0)
            m.mode = MixMode(readChoice(json, WordsOf<MixMode>::list));
        else
            json.read(m.beta);
    });
    requireMembers(json, found, names, m.mode == MixMode::Beta ? memberBit(0) | memberBit(1) : memberBit(0));
    if (json.ok() && m.mode == MixMode::Alpha && (found & memberBit(1)))
        json.failMember("beta", FileMessages::tr("belongs to the mode beta; remove it or change the mode"));
}

void appendJson(QByteArray &out, const Colour &c)
{
    appendNumber(out.append('['), c.red);
    appendNumber(out.append(','), c.yellow);
    appendNumber(out.append(','), c.blue);
    appendNumber(out.append(','), c.opacity);
    out.append(']');
}

void appendJson(QByteArray &out, const Style &style)
{
    out.append("{\"kind\": \"")
        .append(WordsOf<StyleKind>::list[std::size_t(style.kind)].data())
        .append("\", \"xi\": [");
    for (int i = 0; i < xiCount(style.kind); ++i)
        appendNumber(out.append(i ? ", " : ""), style.xi[std::size_t(i)]);
    out.append("]}");
}

void appendJson(QByteArray &out, const Mix &mix)
{
    if (mix.mode == MixMode::Alpha) {
        out.append("{\"mode\": \"alpha\"}");
        return;
    }
    appendNumber(out.append("{\"mode\": \"beta\", \"beta\": "), mix.beta);
    out.append('}');
}

} // namespace suffuse
