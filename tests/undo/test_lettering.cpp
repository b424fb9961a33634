// How texts are set: places, directions, lines, along curves. The fonts are those of the machine; what is checked holds
// for any.
#include "model/formats/files.h"
#include "model/shaping/baseline_curve.h"
#include "model/shaping/transform.h"
#include "undo/lettering/text_layout.h"
#include "undo/lettering/vertical_forms.h"

#include <QFile>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QTest>

#include <numbers>
#include <set>

using namespace suffuse;

namespace {

Text plain(const QString &string)
{
    Text text;
    text.string = string;
    text.family = QStringLiteral("DejaVu Sans");
    text.size = 100;
    return text;
}

LaidText lay(const Text &text)
{
    static TextLayout layout;
    return layout.lay(text);
}

Rect inkOf(const LaidCluster &cluster)
{
    Rect box;
    if (cluster.outline)
        for (const std::vector<Cubic> &contour : *cluster.outline)
            for (const Cubic &curve : contour)
                for (const Point p : curve.p)
                    box.include(cluster.place(p));
    return box;
}

double middleOf(const LaidCluster &cluster)
{
    return 0.5 * (cluster.corners()[0].x + cluster.corners()[1].x);
}

/// A circle of four curves, clockwise from its top.
std::vector<Cubic> circle(double radius)
{
    const double k = 4.0 / 3 * std::tan(std::numbers::pi / 8);
    std::vector<Cubic> curves;
    for (int i = 0; i < 4; ++i) {
        const double a = (i - 1) * std::numbers::pi / 2, b = a + std::numbers::pi / 2;
        const Point from{radius * std::cos(a), radius * std::sin(a)}, to{radius * std::cos(b), radius * std::sin(b)};
        curves.push_back({{from, from + k * Point{-from.y, from.x}, to - k * Point{-to.y, to.x}, to}});
    }
    return curves;
}

} // namespace

class TestLettering : public QObject {
    Q_OBJECT

private slots:
    /// The sample was painted by a script, which set its letters by the same fonts and rules.
    void theSamplesLettersStandWhereTheyAreSet()
    {
        QFile file(QStringLiteral(SUFFUSE_SOURCE_DIR "/packaging/samples/moonrise.suffuse"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const Result<Painting> painting = readPainting(file.readAll(), file.fileName());
        QVERIFY(painting);
        int texts = 0;
        for (const Group &group : painting->groups) {
            if (!group.text)
                continue;
            ++texts;
            const LaidText laid = lay(*group.text);
            if (!laid.hasFamily)
                QSKIP("the font of the sample is not installed");
            std::vector<Rect> set, painted;
            for (const LaidCluster &cluster : laid.clusters)
                if (cluster.hasInk())
                    set.push_back(inkOf(cluster));
            for (const StrokePtr &stroke : painting->strokes)
                if (stroke->group == group.id)
                    painted.push_back(controlBox(*stroke));
            QCOMPARE(painted.size(), set.size());
            for (std::size_t i = 0; i < set.size(); ++i)
                for (const auto &[a, b] :
                     {std::pair(Point{set[i].left, set[i].top}, Point{painted[i].left, painted[i].top}),
                      std::pair(Point{set[i].right, set[i].bottom}, Point{painted[i].right, painted[i].bottom})})
                    QVERIFY2(length(group.text->place(a) - b) < 0.15, // outlines have tenths of a unit
                             qPrintable(QStringLiteral("%1, letter %2: %3, %4, not %5, %6")
                                            .arg(group.name)
                                            .arg(i)
                                            .arg(b.x)
                                            .arg(b.y)
                                            .arg(group.text->place(a).x)
                                            .arg(group.text->place(a).y)));
        }
        QCOMPARE(texts, 2);
    }

    void initTestCase()
    {
        if (!LineShaper().hasFamily(QStringLiteral("DejaVu Sans")))
            QSKIP("DejaVu Sans is not installed");
    }

    void lettersStandBehindEachOther()
    {
        const LaidText laid = lay(plain(QStringLiteral("Hg l")));
        QCOMPARE(laid.clusters.size(), std::size_t(4));
        QVERIFY(laid.hasFamily);
        double at = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const LaidCluster &c = laid.clusters[k];
            QCOMPARE(c.from, qsizetype(k));
            QCOMPARE(c.to, qsizetype(k + 1));
            QVERIFY(std::abs(c.corners()[0].x - at) < 0.05);
            at = c.corners()[1].x;
            QCOMPARE(c.hasInk(), k != 2);
        }
        const Rect ink = inkOf(laid.clusters[0]);
        QVERIFY(std::abs(ink.bottom) < 1e-9);         // H stands on the baseline
        QVERIFY(std::abs(-ink.top - 72.9) < 0.2);     // as high as DejaVu's capitals are
        QVERIFY(inkOf(laid.clusters[1]).bottom > 10); // g hangs below it
        QCOMPARE(laid.caretAt(0)[0].x, 0.0);
        QCOMPARE(laid.caretAt(4), laid.clusters[3].after);
        QCOMPARE(laid.caretAt(2), laid.clusters[1].after);
    }

    /// A font's units are whole numbers, so its outlines are exact in ems.
    void outlinesAreThoseOfTheFont()
    {
        const LaidText laid = lay(plain(QStringLiteral("o")));
        QCOMPARE(laid.clusters.at(0).outline->size(), std::size_t(2));
        for (const std::vector<Cubic> &contour : *laid.clusters[0].outline) {
            QCOMPARE(contour.front().p[0], contour.back().p[3]);
            for (std::size_t k = 0; k < contour.size(); ++k) {
                const Point node = 2048 * contour[k].p[0]; // or the middle of two points
                QCOMPARE(2 * node.x, std::round(2 * node.x));
                QCOMPARE(2 * node.y, std::round(2 * node.y));
                QCOMPARE(contour[k].p[0], contour[k == 0 ? contour.size() - 1 : k - 1].p[3]);
            }
        }
        const LaidText twice = lay(plain(QStringLiteral("oo")));
        QCOMPARE(twice.clusters[0].outline, twice.clusters[1].outline);
        QCOMPARE(twice.clusters[0].outline, laid.clusters[0].outline);
    }

    void quadraticsBecomeTheSameCubics()
    {
        // The second differences of a cubic that is a quadratic are in one line with its third one at zero.
        const LaidText laid = lay(plain(QStringLiteral("o")));
        for (const Cubic &c : laid.clusters[0].outline->front()) {
            const Point third = c.p[3] - 3 * c.p[2] + 3 * c.p[1] - c.p[0];
            QVERIFY(length(third) < 1e-12);
        }
    }

    void sizeAndSpacing()
    {
        Text text = plain(QStringLiteral("abc"));
        const double width = lay(text).box().width();
        text.letterSpacing = 0.5f;
        const LaidText spaced = lay(text);
        QVERIFY(std::abs(spaced.box().width() - width - 2 * 0.5 * 100) < 0.1);
        text.letterSpacing = 0;
        text.size = 200;
        QVERIFY(std::abs(lay(text).box().width() - 2 * width) < 1e-6);
        text.weight = 700;
        QVERIFY(lay(text).box().width() > 2 * width);
    }

    void linesAndAlignment()
    {
        Text text = plain(QStringLiteral("wide line\nab\n\nc"));
        text.lineHeight = 1.5f;
        for (const TextAlignment alignment : {TextAlignment::Start, TextAlignment::Centre, TextAlignment::End}) {
            text.alignment = alignment;
            const LaidText laid = lay(text);
            QCOMPARE(laid.lines.size(), std::size_t(4));
            QCOMPARE(laid.lines[2].from, laid.lines[2].to);
            for (std::size_t k = 0; k < 4; ++k) {
                const LaidLine &line = laid.lines[k];
                const double from = line.start[0].x, to = line.end[0].x;
                const double anchor = alignment == TextAlignment::Start    ? from
                                      : alignment == TextAlignment::Centre ? 0.5 * (from + to)
                                                                           : to;
                QVERIFY(std::abs(anchor) < 1e-9);
                QCOMPARE(laid.lineOf(line.from), int(k));
                QCOMPARE(laid.lineOf(line.to), int(k));
            }
            QVERIFY(std::abs(inkOf(laid.clusters.back()).bottom - 3 * 150) < 3);
        }
    }

    void bothDirections()
    {
        // Latin first: the paragraph runs from the left, the Hebrew word in it from the right.
        const LaidText laid = lay(plain(QStringLiteral("ab \u05d0\u05d1\u05d2 c")));
        QCOMPARE(laid.clusters.size(), std::size_t(8));
        QVERIFY(!laid.lines[0].rightToLeft);
        QVERIFY(laid.clusters[3].rightToLeft && !laid.clusters[0].rightToLeft);
        QVERIFY(middleOf(laid.clusters[3]) > middleOf(laid.clusters[4]));
        QVERIFY(middleOf(laid.clusters[4]) > middleOf(laid.clusters[5]));
        QVERIFY(middleOf(laid.clusters[5]) > middleOf(laid.clusters[1]));
        QVERIFY(middleOf(laid.clusters[7]) > middleOf(laid.clusters[3]));
        QVERIFY(laid.clusters[4].before[0].x > laid.clusters[4].after[0].x);
        // A Hebrew paragraph begins on the right: at its place.
        const LaidText right = lay(plain(QStringLiteral("\u05d0\u05d1 c")));
        QVERIFY(right.lines[0].rightToLeft);
        QVERIFY(std::abs(right.box().right) < 1e-9);
        QVERIFY(std::abs(right.lines[0].start[0].x) < 1e-9);
    }

    void ligaturesAndMarks()
    {
        // What the caret passes as one is one cluster, and every character belongs to one.
        for (const QString &string :
             {QStringLiteral("office a\u0301e\u0323\u0302"), QStringLiteral("\u0644\u0627 \u0645\u062d\u0645\u062f"),
              QStringLiteral("\u0915\u094d\u0937\u093f"), QStringLiteral("\U0001F469\u200D\U0001F680 x"),
              QStringLiteral("\u6c34\u58a8 mixed \u0e01\u0e33")}) {
            const LaidText laid = lay(plain(string));
            qsizetype at = 0;
            for (const LaidCluster &c : laid.clusters) {
                QCOMPARE(c.from, at);
                QVERIFY(c.to > c.from);
                at = c.to;
            }
            QCOMPARE(at, string.size());
        }
    }

    void caretsAreFound()
    {
        Text text = plain(QStringLiteral("Hello wor\u05d0\u05d1ld\nsecond\n\n\u6c34\u58a8 ffi"));
        for (const bool vertical : {false, true})
            for (const bool onCurve : {false, true}) {
                text.vertical = vertical;
                text.curve = onCurve ? circle(900) : std::vector<Cubic>();
                const LaidText laid = lay(text);
                for (qsizetype at = 0; at <= text.string.size(); at = nextPlace(text.string, at)) {
                    const CaretLine caret = laid.caretAt(at);
                    const qsizetype found = laid.positionAt(0.5 * (caret[0] + caret[1]), text.string);
                    // Between two directions two places have one line.
                    const CaretLine other = laid.caretAt(found);
                    QVERIFY(length(caret[0] - other[0]) < 1 && length(caret[1] - other[1]) < 1);
                    if (at == text.string.size())
                        break;
                }
            }
    }

    /// The middle of a letter divides what means before it from what means behind it, however far apart letters stand.
    void theHalfOfALetterIsItsOwnSide()
    {
        for (const QString &string : {QStringLiteral("abcd"), QStringLiteral("\u05d0\u05d1\u05d2\u05d3")})
            for (const float spacing : {0.0f, 0.3f, 1.2f, 4.0f})
                for (const bool vertical : {false, true})
                    for (const bool onCurve : {false, true}) {
                        Text text = plain(string);
                        text.letterSpacing = spacing;
                        text.vertical = vertical;
                        text.curve = onCurve ? circle(900) : std::vector<Cubic>();
                        const LaidText laid = lay(text);
                        for (const LaidCluster &c : laid.clusters) {
                            const Point from = 0.5 * (c.before[0] + c.before[1]), to = 0.5 * (c.after[0] + c.after[1]);
                            QCOMPARE(laid.positionAt(from + 0.35 * (to - from), string), c.from);
                            QCOMPARE(laid.positionAt(from + 0.65 * (to - from), string), c.to);
                            const Point gap = (double(spacing) * text.size / length(to - from)) * (to - from);
                            QCOMPARE(laid.positionAt(to + 0.4 * gap, string), c.to);
                        }
                    }
    }

    void vertical()
    {
        Text text = plain(QStringLiteral("\u6c34\u58a8ab\u3002\n\u8336"));
        text.vertical = true;
        const LaidText laid = lay(text);
        // Without a Chinese font the box that stands in for a letter is as large as it likes.
        const bool hasInk = !QFontDatabase::families(QFontDatabase::SimplifiedChinese).isEmpty();
        // Squares from top to bottom around the axis.
        for (std::size_t k : {std::size_t(0), std::size_t(1)}) {
            const Rect ink = inkOf(laid.clusters[k]);
            QVERIFY(!hasInk || (ink.left > -51 && ink.right < 51));
            QVERIFY(!hasInk || (ink.top > 100.0 * double(k) - 3 && ink.bottom < 100.0 * double(k + 1) + 3));
            QVERIFY(std::abs(laid.clusters[k].before[0].y - 100.0 * double(k)) < 1e-9);
            QVERIFY(laid.clusters[k].place.a == 100 && laid.clusters[k].place.b == 0); // upright
        }
        // Latin letters are turned by 90°, and begin below the squares.
        const LaidCluster &a = laid.clusters[2];
        QVERIFY(a.place.a == 0 && a.place.c == 100);
        QVERIFY(std::abs(a.before[0].y - 200) < 1e-9 && a.after[0].y > a.before[0].y + 30);
        QVERIFY(a.before[0].x > 0 && a.before[1].x < 0);
        if (!hasInk)
            return;
        // The full stop is in the upper right corner of its square, the next line on the left.
        const LaidCluster &stop = laid.clusters[4];
        const Point middle = 0.25 * (stop.before[0] + stop.before[1] + stop.after[0] + stop.after[1]);
        QVERIFY(inkOf(stop).centre().x > middle.x && inkOf(stop).centre().y < middle.y);
        QVERIFY(std::abs(inkOf(laid.clusters[5]).centre().x + 120) < 8);
        QVERIFY(inkOf(laid.clusters[5]).top > -3);
    }

    /// The forms are those that Unicode's data calls vertical forms of the letter, or of what it is a wide form of.
    void formsForVerticalLinesAreUnicodes()
    {
        const auto plainOf = [](QChar c) {
            return c.decompositionTag() == QChar::Wide ? c.decomposition() : QString(c);
        };
        std::set<char16_t> forms;
        for (int code = 0; code <= 0xffff; ++code) {
            const QChar letter{char16_t(code)};
            const std::optional<QChar> form = verticalFormOf(QStringView(&letter, 1), 1);
            if (!form)
                continue;
            QCOMPARE(form->decompositionTag(), QChar::Vertical);
            QCOMPARE(form->decomposition(), plainOf(letter));
            QVERIFY(forms.insert(form->unicode()).second);
        }
        // All of them have a letter, but for ︴, a wavy line below others.
        for (int code = 0xfe10; code <= 0xfe48; ++code)
            if (QChar(char16_t(code)).decompositionTag() == QChar::Vertical && code != 0xfe34)
                QVERIFY2(forms.contains(char16_t(code)), qPrintable(QString::number(code, 16)));
        QCOMPARE(forms.size(), std::size_t(32));
    }

    void chosenFormsForVerticalLines()
    {
        const QString open = QStringLiteral("\u300c"), stop = QStringLiteral("\u3002"),
                      comma = QStringLiteral("\uff0c"), dash = QStringLiteral("\u2014"),
                      dots = QStringLiteral("\u2026"), dashes = QStringLiteral("\u2014\u0301");
        QCOMPARE(verticalFormOf(open, 1), QChar(0xfe41));
        QCOMPARE(verticalFormOf(open, 0.5), QChar(0xfe41));
        // Dashes and dots as wide as a square stand in one, others in Latin text.
        QCOMPARE(verticalFormOf(dash, 1), QChar(0xfe31));
        QCOMPARE(verticalFormOf(dots, 1), QChar(0xfe19));
        QVERIFY(!verticalFormOf(dash, 0.5) && !verticalFormOf(dots, 0.8));
        // Brackets of Latin text are turned with it; what has a mark has no form; letters have none.
        QVERIFY(!verticalFormOf(QStringLiteral("("), 1) && !verticalFormOf(dashes, 1) && !verticalFormOf(QString(), 1));
        QVERIFY(!verticalFormOf(QStringLiteral("\u6c34"), 1));

        QCOMPARE(standOf(open, true), Stand::Upright);
        QCOMPARE(standOf(open, false), Stand::Turned);
        QCOMPARE(standOf(stop, true), Stand::Upright);
        QCOMPARE(standOf(stop, false), Stand::OtherCorner);
        QCOMPARE(standOf(comma, false), Stand::OtherCorner);
        QCOMPARE(standOf(dash, true), Stand::Upright);
        for (const QString &turned : {dash, dots, QStringLiteral("\uff08"), QStringLiteral("\u3011"),
                                      QStringLiteral("\u30fc"), QStringLiteral("a"), QStringLiteral("(")})
            QCOMPARE(standOf(turned, false), Stand::Turned);
        for (const QString &upright :
             {QStringLiteral("\u6c34"), QStringLiteral("\u304b"), QStringLiteral("\uac00"), QStringLiteral("\uff01"),
              QStringLiteral("\ufe41"), QStringLiteral("\U00020000")})
            QCOMPARE(standOf(upright, false), Stand::Upright);
    }

    /// Small letters are capitals that are smaller, and capitals are as they are.
    void smallCaps()
    {
        LineShaper shaper;
        const auto shaped = [&shaper](bool hasSmallCaps) {
            return shaper.shape(QStringLiteral("Hh"),
                                {QStringLiteral("DejaVu Sans"), 400, false, false, false, hasSmallCaps});
        };
        const auto heightOf = [](const ShapedCluster &cluster) {
            Rect box;
            for (const std::vector<Cubic> &contour : *cluster.outline)
                for (const Cubic &curve : contour)
                    box = box.united(curve.controlBox());
            return box.height();
        };
        const std::vector<ShapedCluster> usual = shaped(false)->clusters, small = shaped(true)->clusters;
        QCOMPARE(small.size(), std::size_t(2));
        QCOMPARE(heightOf(small[0]), heightOf(usual[0]));
        const double share = heightOf(small[1]) / heightOf(small[0]);
        QVERIFY2(share > 0.6 && share < 0.9, qPrintable(QString::number(share)));
        QCOMPARE(small[1].outline->size(), small[0].outline->size());
        QVERIFY(std::abs(small[1].width / small[0].width - share) < 0.02);
    }

    /// Whether the font has a form or not, what stands in a bracket's square has its ink where it belongs.
    void bracketsInVerticalLines()
    {
        Text text = plain(QStringLiteral("\u300c\u6c34\u300d"));
        const LaidText across = lay(text);
        text.vertical = true;
        const LaidText laid = lay(text);
        LineShaper shaper;
        const Face face{text.family, text.weight, text.italic, false, true};
        const std::shared_ptr<const ShapedLine> line = shaper.shape(text.string, face);
        const std::vector<ShapedCluster> &shaped = line->clusters;
        QCOMPARE(shaped.size(), std::size_t(3));
        QVERIFY(!shaped[1].hasVerticalForm);
        QCOMPARE(laid.clusters[1].outline, across.clusters[1].outline);
        for (const std::size_t k : {std::size_t(0), std::size_t(2)}) {
            const LaidCluster &c = laid.clusters[k];
            if (shaped[k].hasVerticalForm) {
                QVERIFY(c.place.a == 100 && c.place.b == 0);
                QVERIFY(c.outline && c.outline != across.clusters[k].outline);
            } else {
                QVERIFY(c.place.a == 0 && c.place.c == 100);
                QCOMPARE(c.outline, across.clusters[k].outline);
            }
        }
        // Lines across have none of it.
        for (const ShapedCluster &c : shaper.shape(text.string, {text.family, 400, false, false, false})->clusters)
            QVERIFY(!c.hasVerticalForm);
        if (QFontDatabase::families(QFontDatabase::SimplifiedChinese).isEmpty())
            return;
        // 「 opens in the right part of the lower half of its square, 」 closes in the left part of the upper half.
        for (const auto &[k, sign] : {std::pair(std::size_t(0), 1.0), std::pair(std::size_t(2), -1.0)}) {
            const LaidCluster &c = laid.clusters[k];
            const Point middle = 0.25 * (c.before[0] + c.before[1] + c.after[0] + c.after[1]);
            const Point ink = inkOf(c).centre() - middle;
            QVERIFY2(sign * ink.y > 10, qPrintable(QString::number(ink.y)));
            QVERIFY(std::abs(ink.x) < 30);
        }
    }

    void alongACircle()
    {
        constexpr double radius = 500;
        Text text = plain(QStringLiteral("around and around it goes"));
        text.curve = circle(radius);
        const LaidText straight = lay(plain(text.string)), bent = lay(text);
        for (std::size_t k = 0; k < bent.clusters.size(); ++k) {
            const LaidCluster &c = bent.clusters[k];
            const double along = middleOf(straight.clusters[k]);
            const Point foot = c.place({0.5 * (c.box.left + c.box.right), 0});
            QVERIFY(std::abs(length(foot) - radius) < 0.2); // the circle of curves is off by 0.03 %
            const double angle = along / radius - std::numbers::pi / 2;
            QVERIFY(length(foot - radius * Point{std::cos(angle), std::sin(angle)}) < 0.3);
            // It stands on the circle, and is as large as it was.
            QVERIFY(std::abs(cross(c.place.turned({1, 0}), c.place.turned({0, 1})) - 100 * 100) < 1e-6);
            QVERIFY(std::abs(dot(c.place.turned({0, -1}), foot) - 100 * radius) < 60);
        }
        text.alignment = TextAlignment::Centre;
        const LaidText centred = lay(text);
        const Point first = centred.lines[0].start[1], last = centred.lines[0].end[1];
        QVERIFY(std::abs(first.x + last.x) < 2 && std::abs(first.y - last.y) < 2); // around the lowest point
        text.alignment = TextAlignment::End;
        const LaidText ending = lay(text);
        QVERIFY(length(ending.clusters.back().place({ending.clusters.back().box.right, 0}) - Point{0, -radius}) < 8);
    }

    void pastTheEndsOfACurve()
    {
        Text text = plain(QStringLiteral("longer than its line"));
        text.curve = {{{Point{0, 0}, {30, 40}, {60, 80}, {90, 120}}}};
        const LaidText laid = lay(text);
        for (const LaidCluster &c : laid.clusters) {
            const Point foot = c.place({0, 0});
            QVERIFY(std::abs(cross(foot, Point{0.6, 0.8})) < 1e-6);
        }
        QVERIFY(dot(laid.clusters.back().place({0, 0}), Point{0.6, 0.8}) > 600);
    }

    void lengthsAlongCurves()
    {
        const BaselineCurve length(circle(100));
        QVERIFY(std::abs(length.length() - 2 * std::numbers::pi * 100) < 0.1);
        QVERIFY(suffuse::length(length.at(length.length() / 4).point - Point{100, 0}) < 1e-6);
        QVERIFY(suffuse::length(length.at(0).direction - Point{1, 0}) < 1e-9);
        // A handle on its node leaves a direction all the same.
        const BaselineCurve pinched(std::vector<Cubic>{{{Point{0, 0}, {0, 0}, {10, 10}, {10, 10}}}});
        QVERIFY(suffuse::length(pinched.at(-5).direction - Point{std::sqrt(0.5), std::sqrt(0.5)}) < 1e-9);
        QCOMPARE(BaselineCurve(std::vector<Cubic>()).at(7).point, (Point{7, 0}));
    }

    void aFontThatIsNotThere()
    {
        Text text = plain(QStringLiteral("abc"));
        text.family = QStringLiteral("No Such Family At All");
        const LaidText laid = lay(text);
        QVERIFY(!laid.hasFamily);
        QCOMPARE(laid.clusters.size(), std::size_t(3));
        QVERIFY(laid.clusters[0].hasInk());
    }

    void oddStrings()
    {
        for (const QString &string :
             {QString(), QStringLiteral("\n"), QStringLiteral("\n\n\n"), QStringLiteral("\t\u0007"),
              QStringLiteral("\u200d"), QStringLiteral("\u0301"), QString(QChar(0xd800))}) {
            const LaidText laid = lay(plain(string));
            QVERIFY(!laid.lines.empty());
            for (qsizetype at = 0; at <= string.size(); ++at)
                QVERIFY(std::isfinite(laid.caretAt(at)[0].x));
            QVERIFY(laid.positionAt({1e6, -1e6}, string) <= string.size());
        }
    }

    void words()
    {
        const QString string = QStringLiteral("one, two  three");
        QCOMPARE(nextWord(string, 0), qsizetype(3)); // a comma is a word of its own
        QCOMPARE(nextWord(string, 3), qsizetype(5));
        QCOMPARE(nextWord(string, 4), qsizetype(5));
        QCOMPARE(wordBefore(string, 5), qsizetype(3));
        QCOMPARE(wordBefore(string, 15), qsizetype(10));
        const QString hill = QStringLiteral("Hill & Dale...");
        std::vector<qsizetype> forth, back;
        for (qsizetype at = 0; at < hill.size(); forth.push_back(at))
            at = nextWord(hill, at);
        for (qsizetype at = hill.size(); at > 0; back.push_back(at))
            at = wordBefore(hill, at);
        QCOMPARE(forth, (std::vector<qsizetype>{5, 7, 11, 14}));
        QCOMPARE(back, (std::vector<qsizetype>{11, 7, 5, 0}));
        QCOMPARE(wordAt(string, 6), (std::pair<qsizetype, qsizetype>(5, 8)));
        QCOMPARE(wordAt(string, 15), (std::pair<qsizetype, qsizetype>(10, 15)));
        QCOMPARE(nextPlace(QStringLiteral("a\u0301b"), 0), qsizetype(2));
        QCOMPARE(placeBefore(QStringLiteral("a\u0301b"), 2), qsizetype(0));
        QCOMPARE(placeBefore(QStringLiteral("a"), 0), qsizetype(0));
    }
};

QTEST_MAIN(TestLettering)
#include "test_lettering.moc"
