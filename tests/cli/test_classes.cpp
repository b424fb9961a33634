// A class has one source file: where it grows beyond that, a class is missing.
#include "tests/cli/sources.h"

#include <QRegularExpression>
#include <QTest>

#include <map>
#include <set>

namespace {

/// The classes of which a source defines members outside of the class.
std::set<QString> classesDefinedIn(const QString &text)
{
    // At the start of a line: what is returned, the class, and the member with its parameters.
    static const QRegularExpression member(
        "^(?:[\\w:][\\w:<>,*& ]*[ *&])?([A-Z]\\w*)::(?:~?\\w+|operator[^\\s(]*) *\\(",
        QRegularExpression::MultilineOption);
    std::set<QString> found;
    for (auto it = member.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        if (!match.captured().contains(" = ")) // the value of a constant
            found.insert(match.captured(1));
    }
    return found;
}

/// Classes that still live in several source files, and why.
const std::map<QString, QString> &slicedClasses()
{
    static const std::map<QString, QString> table = {};
    return table;
}

} // namespace

class TestClasses : public QObject {
    Q_OBJECT

private slots:
    void aClassHasOneSourceFile();
    void definitionsAreFound();
};

void TestClasses::aClassHasOneSourceFile()
{
    std::map<QString, QStringList> places;
    forEachSource([&](const QString &path, const QString &text) {
        if (!path.endsWith(".h"))
            for (const QString &name : classesDefinedIn(text))
                places[name].append(path);
    });
    QVERIFY2(places.size() > 100, "the classes were not found");
    for (const auto &[name, files] : places)
        QVERIFY2(files.size() == 1 || slicedClasses().contains(name), qPrintable(name + ": " + files.join(", ")));
    for (const auto &[name, why] : slicedClasses())
        QVERIFY2(places[name].size() > 1, qPrintable(name + " is in one file now: take it from the list"));
}

void TestClasses::definitionsAreFound()
{
    const QString text("A::A() : m_b(1) {}\nconst std::vector<B> &C::all() const\n{\n    D::use();\n}\n"
                       "E::F E::f(G g)\n{\n}\nbool H::operator==(const H &) const\nI::~I() = default;\n"
                       "constexpr int j = K::l(1);\nvoid free(M::N n);\n");
    QCOMPARE(classesDefinedIn(text), std::set<QString>({"A", "C", "E", "H", "I"}));
}

QTEST_GUILESS_MAIN(TestClasses)
#include "test_classes.moc"
