// Typing in a long text.
#include "app/tools/text/text_tool.h"
#include "tests/bench/editing/editing_benches.h"
#include "undo/text_edits.h"

#include <QKeyEvent>

namespace suffuse {

namespace {

constexpr int lines = 40, lettersInLine = 50; // 2,000 letters

void typeLetter(EditingSession &s, QChar letter)
{
    QKeyEvent press(QEvent::KeyPress, letter.toUpper().unicode(), Qt::NoModifier, QString(letter));
    QCoreApplication::sendEvent(&s.canvas(), &press);
}

} // namespace

Report measureTyping(EditingSession &s, int events, const QString &wanted)
{
    Report report{"Typing in a text of 2,000 letters, at 60 events a second: event to the screen, ms", {}};
    const Rect sheet = s.painting().canvas.area();
    QString string;
    for (int i = 0; i < lines; ++i) {
        for (int k = 0; k < lettersInLine; ++k)
            string += QChar('a' + (7 * i + 3 * k) % 26);
        string += i + 1 < lines ? "\n" : "";
    }
    s.window().action(Command::Text).trigger();
    TextEntry &entry = static_cast<TextTool *>(s.canvas().tool())->entry();
    Text text;
    text.family = QGuiApplication::font().family();
    text.size = sheet.height() / (lines * 1.3);
    text.place = Affine::translation({sheet.left + text.size, sheet.top + text.size});
    entry.begin(text);
    entry.type(string);
    entry.finish();
    s.editor().clock().setTime(s.painting().end());
    s.rest();
    const GroupId group = s.painting().groups.back().id;
    if (const QString name = "text: open"; name.contains(wanted)) {
        Times times;
        for (int i = 0; i < 5; ++i) {
            times.ms.push_back(s.untilPainted([&] { entry.open(group); }));
            entry.finish();
            s.rest();
        }
        report.rows.push_back(rowOf(name, times));
    }
    const qsizetype middle = (lines / 2) * (lettersInLine + 1);
    for (const auto &[name, place] : {std::pair(QString("text: at the end of a line"), middle + lettersInLine),
                                      std::pair(QString("text: at the start of a line"), middle)}) {
        if (!name.contains(wanted))
            continue;
        entry.open(group);
        entry.moveTo(place, false);
        s.rest();
        report.rows.push_back(rowOf(name, s.paced(events, [&](int i) {
            // One letter comes and goes.
            if (i % 2 == 0)
                typeLetter(s, QChar('x'));
            else
                entry.eraseTo(entry.caret() - 1);
        })));
        entry.giveUp();
        s.rest();
    }
    s.editor().undo();
    s.window().action(Command::Brush).trigger();
    s.settle();
    return report;
}

} // namespace suffuse
