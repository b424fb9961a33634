#include "app/extensions/manifest.h"

#include "app/extensions/field_values.h"
#include "model/formats/text/json_reader.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace suffuse {

namespace {

using MemberNames = std::string_view;

constexpr int mostFields = 64, mostEntries = 256;
constexpr int mostSeconds = 3600, mostMegabytes = 65536;

class ManifestReader {
public:
    ManifestReader(const QByteArray &bytes, const QString &path) : m_json(bytes, path)
    {
        m_extension.folder = QFileInfo(path).absolutePath();
    }

    Result<Extension> read()
    {
        members();
        m_json.finish();
        if (!m_json.ok())
            return Error{m_json.error()};
        return std::move(m_extension);
    }

private:
    void members()
    {
        static constexpr MemberNames names[] = {"format", "version", "id",      "name",         "description",
                                                "menu",   "fields",  "passes",  "form",         "returns",
                                                "run",    "limits",  "network", "pythonModules"};
        Extension &e = m_extension;
        const auto found = m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                return fixed(QStringLiteral("suffuse-extension"));
            case 1:
                return version();
            case 2:
                return id(e.id, "^[a-z][a-z0-9-]{0,63}$");
            case 3:
                return words(e.name);
            case 4:
                return words(e.description);
            case 5:
                return menu();
            case 6:
                return fields();
            case 7:
                e.passes = Extension::Passes(oneOf({"painting", "selection", "layer"}));
                return;
            case 8:
                e.asText = oneOf({"text", "suffuse"}) == 0;
                return;
            case 9:
                e.returnsPainting = oneOf({"painting", "nothing"}) == 0;
                return;
            case 10:
                return texts(e.program);
            case 11:
                return limits();
            case 12:
                return m_json.read(e.network);
            default:
                return texts(e.pythonModules);
            }
        });
        need(found, names, {0, 1, 2, 3, 10});
        if (m_json.ok() && e.program.isEmpty())
            m_json.failMember("run", ExtensionMessages::tr("name the program, and what it is started with"));
    }

    /// Fails where one of the members is missing.
    void need(std::uint32_t found, std::span<const MemberNames> names, std::initializer_list<int> wanted)
    {
        for (const int k : wanted)
            if (m_json.ok() && !(found >> k & 1))
                m_json.failMember(names[std::size_t(k)], ExtensionMessages::tr("is missing"));
    }

    void fixed(const QString &wanted)
    {
        QString word;
        m_json.read(word);
        if (m_json.ok() && word != wanted)
            m_json.fail(ExtensionMessages::tr("“%1” is not “%2”").arg(word, wanted));
    }

    void version()
    {
        std::uint64_t number = 0;
        m_json.read(number);
        if (m_json.ok() && number != manifestVersion)
            m_json.fail(ExtensionMessages::tr("version %1 is not known; this program reads version %2")
                            .arg(number)
                            .arg(manifestVersion));
    }

    void id(QString &value, const char *pattern)
    {
        m_json.read(value);
        if (m_json.ok() && !QRegularExpression(QLatin1String(pattern)).match(value).hasMatch())
            m_json.fail(ExtensionMessages::tr("“%1” does not look like %2").arg(value, QLatin1String(pattern)));
    }

    /// A text, which is English, or an object of texts by language.
    void words(Words &value)
    {
        static constexpr MemberNames languages[] = {"en", "de", "zh_CN", "fr", "es", "ja"};
        if (m_json.isObjectNext()) {
            m_json.object(languages, [&](int k) {
                m_json.read(value.byLanguage[QString::fromUtf8(languages[k].data(), qsizetype(languages[k].size()))]);
            });
        } else {
            m_json.read(value.byLanguage[QStringLiteral("en")]);
        }
        if (!m_json.ok())
            return;
        for (const auto &[language, text] : value.byLanguage)
            if (text.trimmed().isEmpty() || text.size() > 2000)
                return m_json.fail(ExtensionMessages::tr("a text has 1 to 2000 characters"));
        if (value.isEmpty())
            m_json.fail(ExtensionMessages::tr("give a text, or one for each language"));
    }

    int oneOf(std::initializer_list<const char *> known)
    {
        QString word;
        m_json.read(word);
        const auto at =
            std::find_if(known.begin(), known.end(), [&](const char *k) { return word == QLatin1String(k); });
        if (m_json.ok() && at == known.end()) {
            QStringList list;
            for (const char *k : known)
                list << QLatin1String(k);
            m_json.fail(ExtensionMessages::tr("“%1” is none of %2").arg(word, list.join(QStringLiteral(", "))));
        }
        return at == known.end() ? 0 : int(at - known.begin());
    }

    void texts(QStringList &list)
    {
        m_json.array([&](std::size_t) {
            QString text;
            m_json.read(text);
            if (m_json.ok() && (text.isEmpty() || text.size() > 4096 || list.size() >= mostEntries))
                m_json.fail(ExtensionMessages::tr("give at most %1 texts of 1 to 4096 characters").arg(mostEntries));
            list << text;
        });
    }

    void menu()
    {
        m_json.array([&](std::size_t i) {
            words(m_extension.menu.emplace_back());
            if (m_json.ok() && i >= 3)
                m_json.fail(ExtensionMessages::tr("there are at most 3 submenus within each other"));
        });
    }

    void limits()
    {
        static constexpr MemberNames names[] = {"seconds", "memory", "written"};
        m_json.object(names, [&](int k) {
            ExtensionLimits &l = m_extension.limits;
            int &limit = k == 0 ? l.seconds : k == 1 ? l.memory : l.written;
            whole(limit, k == 0 ? 1 : 16, k == 0 ? mostSeconds : mostMegabytes);
        });
    }

    void whole(int &value, int least, int most)
    {
        std::uint64_t number = 0;
        m_json.read(number);
        if (m_json.ok() && (number < std::uint64_t(least) || number > std::uint64_t(most)))
            return m_json.fail(ExtensionMessages::tr("%1 is not in [%2, %3]").arg(number).arg(least).arg(most));
        value = int(number);
    }

    void fields()
    {
        std::set<QString> ids;
        m_json.array([&](std::size_t i) {
            ExtensionField &f = m_extension.fields.emplace_back();
            field(f);
            if (m_json.ok() && i >= mostFields)
                m_json.fail(ExtensionMessages::tr("there are at most %1 fields").arg(mostFields));
            if (m_json.ok() && !ids.insert(f.id).second)
                m_json.failMember("id", ExtensionMessages::tr("two fields are called %1").arg(f.id));
        });
    }

    void field(ExtensionField &f)
    {
        static constexpr MemberNames names[] = {"type", "id",       "label",   "tip",  "default", "least",
                                                "most", "decimals", "choices", "unit", "mode",    "endings"};
        bool isTyped = false;
        const auto found = m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                isTyped = true;
                f.type = ExtensionField::Type(oneOf({"number", "whole", "choice", "switch", "text", "colour", "file"}));
                return;
            case 1:
                return id(f.id, "^[A-Za-z][A-Za-z0-9_]{0,63}$");
            case 2:
                return words(f.label);
            case 3:
                return words(f.tip);
            case 4:
                return isTyped ? usual(f)
                               : m_json.fail(ExtensionMessages::tr("the field's type must stand before its default"));
            case 5:
                return m_json.read(f.least);
            case 6:
                return m_json.read(f.most);
            case 7:
                return whole(f.decimals, 0, 8);
            case 8:
                return choices(f);
            case 9:
                return words(f.unit);
            case 10:
                f.saves = oneOf({"open", "save"}) == 1;
                return;
            default:
                return texts(f.endings);
            }
        });
        need(found, names, {0, 1, 2});
        if (f.type != ExtensionField::Type::Switch && f.type != ExtensionField::Type::File &&
            f.type != ExtensionField::Type::Text)
            need(found, names, {4});
        if (f.type == ExtensionField::Type::Number || f.type == ExtensionField::Type::Whole)
            need(found, names, {5, 6});
        if (f.type == ExtensionField::Type::Choice)
            need(found, names, {8});
        checkField(f);
    }

    /// The default, as its type has it.
    void usual(ExtensionField &f)
    {
        switch (f.type) {
        case ExtensionField::Type::Number:
        case ExtensionField::Type::Whole: {
            double number = 0;
            m_json.read(number);
            f.usual = number;
            return;
        }
        case ExtensionField::Type::Switch: {
            bool on = false;
            m_json.read(on);
            f.usual = on;
            return;
        }
        case ExtensionField::Type::Colour: {
            std::array<double, 4> colour{};
            m_json.readAll(colour);
            f.usual = QJsonArray{colour[0], colour[1], colour[2], colour[3]};
            return;
        }
        default: {
            QString text;
            m_json.read(text);
            f.usual = text;
            return;
        }
        }
    }

    void choices(ExtensionField &f)
    {
        static constexpr MemberNames names[] = {"id", "label"};
        m_json.array([&](std::size_t i) {
            ExtensionField::Choice &choice = f.choices.emplace_back();
            const auto found = m_json.object(names, [&](int k) {
                if (k == 0)
                    id(choice.id, "^[A-Za-z0-9_-]{1,64}$");
                else
                    words(choice.label);
            });
            need(found, names, {0, 1});
            if (m_json.ok() && i >= mostEntries)
                m_json.fail(ExtensionMessages::tr("there are at most %1 choices").arg(mostEntries));
        });
    }

    void checkField(ExtensionField &f)
    {
        if (!m_json.ok())
            return;
        if (!(f.least < f.most) && (f.type == ExtensionField::Type::Number || f.type == ExtensionField::Type::Whole))
            return m_json.failMember("most", ExtensionMessages::tr("is not above least"));
        if (f.type == ExtensionField::Type::Whole && std::max(std::abs(f.least), std::abs(f.most)) > 1e9)
            return m_json.failMember("most", ExtensionMessages::tr("whole numbers are from -1000000000 to 1000000000"));
        for (const QString &ending : f.endings)
            if (!QRegularExpression(QStringLiteral("^[A-Za-z0-9.]{1,16}$")).match(ending).hasMatch())
                return m_json.failMember(
                    "endings", ExtensionMessages::tr("“%1” is no ending; give it without its dot").arg(ending));
        if (f.type == ExtensionField::Type::Switch && f.usual.isNull())
            f.usual = false;
        if ((f.type == ExtensionField::Type::File || f.type == ExtensionField::Type::Text) && f.usual.isNull())
            f.usual = QString();
        if (f.type == ExtensionField::Type::File)
            return; // It is chosen anew each time.
        if (const QString problem = problemOfValue(f, f.usual); !problem.isEmpty())
            m_json.failMember("default", problem);
    }

    JsonReader m_json;
    Extension m_extension;
};

} // namespace

QString Words::in(const QString &language) const
{
    for (const QString &wanted : {language, language.section('_', 0, 0), QStringLiteral("en")})
        if (const auto at = byLanguage.find(wanted); at != byLanguage.end())
            return at->second;
    return byLanguage.empty() ? QString() : byLanguage.begin()->second;
}

Result<Extension> readManifest(const QByteArray &bytes, const QString &path)
{
    return ManifestReader(bytes, path).read();
}

} // namespace suffuse
