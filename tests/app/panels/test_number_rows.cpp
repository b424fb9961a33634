// Every number of a segment has its row in the inspector, with its domain and default: also one that was just added.
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/numbers/display.h"
#include "app/widgets/numbers/quantity.h"
#include "tests/app/panel_bench.h"
#include "tests/model/tried_segment.h"

#include <QGridLayout>
#include <QSignalSpy>

using namespace suffuse;
using test::TriedSegment;

class TestNumberRows : public QObject {
    Q_OBJECT

private slots:
    /// Large numbers are grouped where they are read, and not where they are typed.
    void largeNumbersAreGrouped()
    {
        QCOMPARE(lengthDisplay().text(879'364), QLocale().toString(879'364) + canvasUnit());
        QVERIFY(lengthDisplay().text(879'364) != lengthDisplay().number(879'364) + canvasUnit());
        QCOMPARE(lengthDisplay().text(9'364), lengthDisplay().number(9'364) + canvasUnit());
        QCOMPARE(lengthDisplay().number(879'364), QStringLiteral("879364"));
    }

    void everyNumberHasARow()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {300, 1100});
        bench.select({1}, {{1, 1}});
        SegmentSection &section = *panel.segmentSection();
        int colours = 0;
        for (const Number<Segment> &number : numbersOf<Segment>) {
            static constexpr std::array rows{ColourRows::Red, ColourRows::Yellow, ColourRows::Blue,
                                             ColourRows::Opacity};
            SliderField *row =
                number.member ? section.row(number.member) : section.colour()->row(rows[std::size_t(colours++)]);
            QVERIFY2(row, number.name);
            QCOMPARE(row->minimum(), number.traits.domain.leastFloat());
            QCOMPARE(row->maximum(), number.traits.domain.greatest);
        }
        QCOMPARE(colours, 4);
        QCOMPARE(section.row(&Segment::density), section.density());
    }

    void everyNumberCanBeSet()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {300, 1100});
        bench.select({1}, {{1, 1}});
        for (const Number<Segment> &number : numbersOf<Segment>) {
            if (!number.member)
                continue;
            emit panel.segmentSection()->row(number.member)->edited(0.75, nullptr);
            QCOMPARE(number.of(bench.stroke(1).segments[1]), 0.75f);
        }
    }

    void oneMoreHasARow()
    {
        std::vector<float TriedSegment::*> shown;
        for (const Number<Segment> &number : numbersOf<Segment>)
            if (number.member)
                shown.push_back(number.member);
        const auto others = otherNumbers(shown);
        QCOMPARE(others.size(), std::size_t(1));
        const Number<TriedSegment> &wetness = others.front();
        QWidget parent;
        QGridLayout grid(&parent);
        SliderField row(plainSpec(wetness.name, wetness.traits, wetness.usual()), grid, 0, &parent);
        QCOMPARE(row.label()->text(), QStringLiteral("water.wetness"));
        QCOMPARE(row.minimum(), 0.0);
        QCOMPARE(row.maximum(), 1.0);
        TriedSegment segment;
        row.setValue(double(wetness.of(segment)));
        QVERIFY(row.number()->text().startsWith(QStringLiteral("25")));
        connect(&row, &SliderField::edited, this, [&](double value) { wetness.of(segment) = float(value); });
        type(*row.number(), QStringLiteral("60"));
        QCOMPARE(segment.wetness, 0.6f);
        QSignalSpy refused(&row, &SliderField::refused);
        type(*row.number(), QStringLiteral("160"));
        QCOMPARE(segment.wetness, 0.6f);
        QVERIFY(!refused.isEmpty() && !refused.last().first().toString().isEmpty());
    }

    /// Keys and the wheel step from what was typed, though it has not been entered yet; what cannot be read is not
    /// stepped.
    void stepsGoOnFromWhatWasTyped()
    {
        NumberField field;
        field.setRange(0, 1000);
        field.setStep(1);
        QSignalSpy entered(&field, &NumberField::entered), stepped(&field, &NumberField::stepped);
        const auto typed = [&](const QString &text) {
            field.setValue(207.6);
            field.selectAll();
            QTest::keyClicks(&field, text);
        };
        typed(QStringLiteral("300"));
        QTest::keyClick(&field, Qt::Key_Up);
        QCOMPARE(field.value(), std::optional(301.0));
        QCOMPARE(int(entered.size()), 1);
        typed(QStringLiteral("400"));
        QWheelEvent wheel({3, 3}, field.mapToGlobal(QPointF(3, 3)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&field, &wheel);
        QCOMPARE(field.value(), std::optional(399.0));
        stepped.clear();
        typed(QStringLiteral("4x"));
        QTest::keyClick(&field, Qt::Key_Up);
        QCOMPARE(field.value(), std::optional(207.6));
        QVERIFY(stepped.isEmpty());
        QTest::keyClick(&field, Qt::Key_Up); // The number that stands there again does go on.
        QCOMPARE(field.value(), std::optional(208.6));
    }

    /// A step beyond the end says what the end is, and one back is taken.
    void aStepBeyondTheEndSaysSo()
    {
        NumberField field;
        field.setRange(0, 1);
        field.setStep(0.5);
        field.setValue(0.75);
        QSignalSpy refused(&field, &NumberField::refused), stepped(&field, &NumberField::stepped);
        const auto said = [&] { return refused.isEmpty() ? QString() : refused.last().first().toString(); };
        QTest::keyClick(&field, Qt::Key_Up);
        QCOMPARE(field.value(), std::optional(1.0));
        QCOMPARE(said(), QString());
        QTest::keyClick(&field, Qt::Key_Up);
        QCOMPARE(int(stepped.size()), 1);
        QVERIFY(said().startsWith("1 ") && said().contains("most"));
        for (int i = 0; i < 2; ++i) {
            QTest::keyClick(&field, Qt::Key_Down);
            QCOMPARE(said(), QString());
        }
        QTest::keyClick(&field, Qt::Key_Down);
        QVERIFY(said().startsWith("0 ") && said().contains("least"));
    }
};

QTEST_MAIN(TestNumberRows)
#include "test_number_rows.moc"
