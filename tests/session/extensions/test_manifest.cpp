// Manifests of extensions, the values of their fields, and where they are found.
#include "app/extensions/field_values.h"
#include "app/extensions/found_extensions.h"
#include "app/session/extensions/extension_library.h"
#include "app/session/settings/settings.h"
#include "extension_folder.h"

#include <QJsonArray>
#include <QRandomGenerator>
#include <QSignalSpy>

using namespace suffuse;

namespace {

QByteArray manifest(const QByteArray &members)
{
    return R"({"format": "suffuse-extension", "version": 1, "id": "a-b", "name": "Name", "run": ["x"])" + members + "}";
}

QByteArray field(const QByteArray &members)
{
    return manifest(R"(, "fields": [{)" + members + "}]");
}

const QByteArray everyField = R"(, "menu": [{"en": "Marks", "de": "Zeichen"}], "passes": "selection", "form": "suffuse",
 "returns": "nothing", "limits": {"seconds": 5, "memory": 100, "written": 20}, "network": true,
 "pythonModules": ["suffuse"], "description": "It does.", "fields": [
 {"type": "number", "id": "gap", "label": {"en": "Gap", "de": "Abstand"}, "unit": "units", "least": 0.5, "most": 50, "default": 4,
  "decimals": 1, "tip": "Between lines"},
 {"type": "whole", "id": "count", "label": "Count", "least": 1, "most": 9, "default": 3},
 {"type": "choice", "id": "kind", "label": "Kind", "choices": [{"id": "a", "label": "A"}, {"id": "b", "label": "B"}], "default": "b"},
 {"type": "switch", "id": "on", "label": "On", "default": true},
 {"type": "text", "id": "words", "label": "Words", "default": "hello"},
 {"type": "colour", "id": "paint", "label": "Paint", "default": [0, 0.5, 1, 1]},
 {"type": "file", "id": "target", "label": "File", "mode": "save", "endings": ["png", "tif"]}])";

} // namespace

class TestManifest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void everyMemberIsRead()
    {
        const Result<Extension> read = readManifest(manifest(everyField), "/x/y/manifest.json");
        QVERIFY2(read, qPrintable(read.error()));
        const Extension &e = *read;
        QCOMPARE(e.folder, "/x/y");
        QCOMPARE(e.id, "a-b");
        QCOMPARE(e.name.in("de"), "Name"); // English stands in for it
        QCOMPARE(e.menu.size(), 1u);
        QCOMPARE(e.menu[0].in("de"), "Zeichen");
        QVERIFY(e.passes == Extension::Passes::Selection && !e.asText && !e.returnsPainting && e.network);
        QCOMPARE(e.limits.seconds, 5);
        QCOMPARE(e.limits.memory, 100);
        QCOMPARE(e.limits.written, 20);
        QCOMPARE(e.pythonModules, QStringList("suffuse"));
        QCOMPARE(e.fields.size(), 7u);
        QCOMPARE(e.fields[0].label.in("de"), "Abstand");
        QCOMPARE(e.fields[0].least, 0.5);
        QCOMPARE(e.fields[0].decimals, 1);
        QCOMPARE(e.fields[2].choices.size(), 2u);
        QVERIFY(e.fields[6].saves);
        const QJsonObject expected{{"gap", 4.0},  {"count", 3.0},     {"kind", "b"},
                                   {"on", true},  {"words", "hello"}, {"paint", QJsonArray{0.0, 0.5, 1.0, 1.0}},
                                   {"target", ""}};
        QCOMPARE(usualValues(e), expected);
    }

    void wrongOnesSayWhere_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("says");
        const auto row = [](const char *name, const QByteArray &bytes, const char *says) {
            QTest::newRow(name) << bytes << QString::fromUtf8(says);
        };
        row("empty", "", "m.json: ");
        row("no object", "[]", "an object {…}");
        row("cut off", manifest("").chopped(1), "cut off");
        row("other format", R"({"format": "x"})", "format: “x” is not “suffuse-extension”");
        row("later version", R"({"format": "suffuse-extension", "version": 2})", "version: version 2 is not known");
        row("no id", R"({"format": "suffuse-extension", "version": 1, "name": "N", "run": ["x"]})", "id: is missing");
        row("no program", R"({"format": "suffuse-extension", "version": 1, "name": "N", "id": "x"})",
            "run: is missing");
        row("unknown member", manifest(R"(, "colour": 1)"), "colour");
        row("id with a path", R"({"format": "suffuse-extension", "version": 1, "id": "../x"})", "id: “../x”");
        row("no English", manifest(R"(, "description": {})"), "description: give a text");
        row("unknown type", field(R"("type": "slider", "id": "a", "label": "A")"),
            "fields[0].type: “slider” is none of");
        row("type too late", field(R"("default": 1, "type": "number", "id": "a", "label": "A")"),
            "fields[0].default: the field's type must stand before");
        row("no range", field(R"("type": "number", "id": "a", "label": "A", "default": 1)"),
            "fields[0].least: is missing");
        row("default out of range",
            field(R"("type": "number", "id": "a", "label": "A", "default": 9, "least": 0, "most": 1)"),
            "fields[0].default: 9 is not in [0, 1]");
        row("range upside down",
            field(R"("type": "number", "id": "a", "label": "A", "default": 9, "least": 1, "most": 1)"),
            "fields[0].most: is not above least");
        row("choice that is none",
            field(
                R"("type": "choice", "id": "a", "label": "A", "choices": [{"id": "x", "label": "X"}], "default": "y")"),
            "fields[0].default: “y” is none of x");
        row("same id twice",
            manifest(
                R"(, "fields": [{"type": "switch", "id": "a", "label": "A"}, {"type": "switch", "id": "a", "label": "A"}])"),
            "fields[1].id: two fields are called a");
        row("limit too high", manifest(R"(, "limits": {"seconds": 99999})"),
            "limits.seconds: 99999 is not in [1, 3600]");
    }
    void wrongOnesSayWhere()
    {
        QFETCH(const QByteArray, bytes);
        QFETCH(const QString, says);
        const Result<Extension> read = readManifest(bytes, "m.json");
        QVERIFY(!read);
        QVERIFY2(read.error().startsWith("m.json: ") && read.error().contains(says), qPrintable(read.error()));
    }

    /// Whatever stands in a manifest, it is read or refused with its name.
    void damagedOnesAreReadOrRefused()
    {
        const QByteArray whole = manifest(everyField);
        QRandomGenerator random(7);
        int refused = 0;
        for (int i = 0; i < 3000; ++i) {
            QByteArray bytes = whole;
            for (int k = random.bounded(1, 4); k > 0; --k) {
                const auto at = qsizetype(random.bounded(int(bytes.size())));
                if (random.bounded(2))
                    bytes[at] = char(random.bounded(256));
                else
                    bytes.remove(at, random.bounded(1, 20));
            }
            const Result<Extension> read = readManifest(bytes, "m.json");
            if (!read)
                QVERIFY2(read.error().startsWith("m.json: "), qPrintable(read.error()));
            refused += !read;
        }
        QVERIFY(refused > 1000);
    }

    void valuesAreCheckedAndKept()
    {
        const Extension e = *readManifest(manifest(everyField), "/x/y/manifest.json");
        const auto problem = [&](const char *id, const QString &text) {
            const Result<QJsonValue> value = valueOfText(*fieldOf(e, id), text);
            return value ? QStringLiteral("fine: ") + textOfValue(*value) : value.error();
        };
        QCOMPARE(problem("gap", "2.5"), "fine: 2.5");
        QCOMPARE(problem("gap", "0.1"), "0.1 is not in [0.5, 50]");
        QCOMPARE(problem("gap", "nan"), "give a number");
        QCOMPARE(problem("gap", "wide"), "“wide” is no number");
        QCOMPARE(problem("count", "2.5"), "2.5 is no whole number");
        QCOMPARE(problem("kind", "a"), "fine: a");
        QCOMPARE(problem("kind", "c"), "“c” is none of a, b");
        QCOMPARE(problem("on", "false"), "fine: false");
        QCOMPARE(problem("on", "no"), "“no” is neither true nor false");
        QCOMPARE(problem("paint", "1,0,0.25,1"), "fine: 1,0,0.25,1");
        QCOMPARE(problem("paint", "1,0,2,1"), "a colour is red, yellow, blue and opacity, each from 0 to 1");
        QVERIFY(problem("target", m_folder.filePath("a.gif")).contains("must end with .png, .tif"));
        QVERIFY(problem("target", m_folder.filePath("no/a.png")).contains("there is no such folder"));
        QCOMPARE(problem("target", m_folder.filePath("a.png")), "fine: " + m_folder.filePath("a.png"));
        QCOMPARE(problemOfValues(e, usualValues(e), "en"), "File: choose a file");

        ExtensionLibrary &library = ExtensionLibrary::instance();
        QJsonObject values = usualValues(e);
        values["gap"] = 7.5;
        values["paint"] = QJsonArray{1.0, 0.0, 0.0, 0.5};
        library.keepValues(e, values);
        QCOMPARE(library.valuesOf(e), values);
        settings::store().setValue("extensions/values/a-b/gap", "1000"); // as another version of it may have had
        values["gap"] = 4.0;
        QCOMPARE(library.valuesOf(e), values);
    }

    void foldersAreSearched()
    {
        const QString shipped = m_folder.filePath("shipped"), own = m_folder.filePath("own");
        writeExtension(shipped, "one", "exit 0");
        writeExtension(shipped, "two", "exit 0");
        writeExtension(own, "two", "exit 0");
        put(writeExtension(own, "broken", "exit 0") + "/manifest.json", "{");
        QDir().mkpath(own + "/no-extension");
        QDir().mkpath(own + "/copy");
        QVERIFY(QFile::copy(own + "/two/manifest.json", own + "/copy/manifest.json"));
        const std::vector<FoundExtension> found = findExtensions({shipped, own}, "en");
        QStringList names;
        for (const FoundExtension &f : found)
            names << QFileInfo(f.folder).fileName() + (f.extension ? "" : "!") + (f.isOwn ? " own" : "");
        std::ranges::sort(names);
        QCOMPARE(names, QStringList({"broken! own", "copy own", "one", "two! own"}));
        for (const FoundExtension &f : found)
            QCOMPARE(f.problem.isEmpty(), f.extension.has_value());
    }

    void thoseThatCameAlongAreWhole()
    {
        QStringList ids;
        for (const FoundExtension &found : findExtensions({shippedExtensionsFolder(), QString()}, "en")) {
            QVERIFY2(found.extension, qPrintable(found.problem));
            const Extension &e = *found.extension;
            ids << e.id;
            QList<Words> words{e.name, e.description};
            words += QList<Words>(e.menu.begin(), e.menu.end());
            for (const ExtensionField &field : e.fields) {
                words << field.label;
                if (!field.tip.isEmpty())
                    words << field.tip;
                if (!field.unit.isEmpty())
                    words << field.unit;
                QVERIFY2(field.unit.in("en") != "units", qPrintable(e.id)); // Fields of the window say u.
                for (const ExtensionField::Choice &choice : field.choices)
                    words << choice.label;
            }
            for (const Words &each : words)
                for (const char *language : {"en", "de", "zh_CN", "fr", "es", "ja"})
                    QVERIFY2(each.byLanguage.contains(language), qPrintable(e.id + ": " + each.in("en")));
        }
        std::ranges::sort(ids);
        QCOMPARE(ids, QStringList({"contact-sheet", "hatch", "jitter", "kaleidoscope", "recolour-palette"}));
    }

    void programsAreLookedFor()
    {
        Extension e = *readManifest(manifest(""), "/x/y/manifest.json");
        e.program = {"sh", "{folder}/a.sh"};
        QVERIFY(commandOf(e).first().endsWith("/sh"));
        QCOMPARE(commandOf(e).last(), "/x/y/a.sh");
        QCOMPARE(problemOfNeeds(e), QString());
        e.program = {"suffuse-no-such-program"};
        QVERIFY(problemOfNeeds(e).contains("suffuse-no-such-program is missing"));
        e.program = {"{python3}", "{folder}/a.py"};
        if (python3().isEmpty())
            QSKIP("no Python");
        e.pythonModules = {"json", "no_such_module_of_suffuse"};
        QVERIFY(problemOfNeeds(e).contains("no_such_module_of_suffuse"));
        QVERIFY(!problemOfNeeds(e).contains("json"));
        e.pythonModules = {"json"};
        QCOMPARE(problemOfNeeds(e), QString());
    }

    void oneThatIsNotEnabledIsNotUsable()
    {
        ExtensionLibrary &library = ExtensionLibrary::instance();
        QVERIFY(library.usable("hatch"));
        const QSignalSpy changed(&library, &ExtensionLibrary::changed);
        library.setEnabled("hatch", false);
        QVERIFY(!library.usable("hatch") && library.usable("jitter"));
        library.setEnabled("hatch", true);
        QVERIFY(library.usable("hatch"));
        QCOMPARE(changed.count(), 2);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestManifest)
#include "test_manifest.moc"
