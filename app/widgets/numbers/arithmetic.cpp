#include "app/widgets/numbers/arithmetic.h"

#include "app/widgets/numbers/display.h"
#include "model/painting/resolution.h"

#include <QLocale>
#include <QRegularExpression>

#include <cmath>
#include <functional>

namespace suffuse {

namespace {

/// Parses a sum of products by recursive descent. Nesting is bounded so that no input exhausts the stack.
class Parser {
public:
    explicit Parser(const QString &text) : m_text(text) {}

    std::optional<double> whole()
    {
        const std::optional<double> value = sum(0);
        return value && m_at == m_text.size() && std::isfinite(*value) ? value : std::nullopt;
    }

private:
    QChar peek() const { return m_at < m_text.size() ? m_text[m_at] : QChar(); }

    std::optional<double> sum(int depth)
    {
        std::optional<double> left = product(depth);
        while (left && (peek() == '+' || peek() == '-')) {
            const bool minus = m_text[m_at++] == '-';
            const std::optional<double> right = product(depth);
            left = right ? std::optional(minus ? *left - *right : *left + *right) : std::nullopt;
        }
        return left;
    }

    std::optional<double> product(int depth)
    {
        std::optional<double> left = factor(depth);
        while (left && (peek() == '*' || peek() == '/')) {
            const bool divide = m_text[m_at++] == '/';
            const std::optional<double> right = factor(depth);
            left = right ? std::optional(divide ? *left / *right : *left * *right) : std::nullopt;
        }
        return left;
    }

    std::optional<double> factor(int depth)
    {
        if (depth > 32)
            return std::nullopt;
        if (peek() == '-' || peek() == '+') {
            const bool minus = m_text[m_at++] == '-';
            const std::optional<double> value = factor(depth + 1);
            return value && minus ? std::optional(-*value) : value;
        }
        if (peek() == '(') {
            ++m_at;
            const std::optional<double> value = sum(depth + 1);
            if (!value || peek() != ')')
                return std::nullopt;
            ++m_at;
            return value;
        }
        return number();
    }

    std::optional<double> number()
    {
        const qsizetype start = m_at;
        while (peek().isDigit() || peek() == '.')
            ++m_at;
        if (m_at > start && peek().toLower() == 'e') {
            ++m_at;
            if (peek() == '+' || peek() == '-')
                ++m_at;
            while (peek().isDigit())
                ++m_at;
        }
        bool ok = false;
        const double value = m_text.mid(start, m_at - start).toDouble(&ok);
        return ok ? std::optional(value) : std::nullopt;
    }

    QString m_text;
    qsizetype m_at = 0;
};

/// A unit that may be typed in a field of another unit, and what it is worth there.
struct OtherUnit {
    const char *name;
    const char *field;
    double factor;
};

/// The name in the table of a unit as fields show it.
QString plainUnit(const QString &shown)
{
    const std::pair<QString, const char *> names[] = {{canvasUnit(), "u"},
                                                      {millimetreUnit(), "mm"},
                                                      {inchUnit(), "in"},
                                                      {secondsUnit(), "s"},
                                                      {diffusionUnit(), "u²/s"}};
    for (const auto &[unit, name] : names)
        if (shown == unit.trimmed())
            return QString::fromUtf8(name);
    return shown;
}

/// Millimetres in a unit of paper; in px and canvas units by the resolution. 0: it is no length, or nobody knows.
double millimetresOf(const QString &name, double resolution)
{
    if (name == QLatin1String("u") || name == QLatin1String("px"))
        return resolution > 0 ? millimetresOfInch / resolution : 0;
    static const std::pair<const char *, double> units[] = {
        {"mm", 1}, {"cm", 10}, {"in", millimetresOfInch}, {"pt", millimetresOfInch / 72}};
    for (const auto &[unit, worth] : units)
        if (name == QLatin1String(unit))
            return worth;
    return 0;
}

double worthOf(const QString &shownName, const QString &shownField, double resolution)
{
    const QString name = plainUnit(shownName), field = plainUnit(shownField);
    static const OtherUnit units[] = {
        {"ms", "s", 1e-3},
        {"min", "s", 60},
        {"px", "u", 1},
        {"u", "px", 1},
        {"deg", "°", 1},
        {"px²/s", "u²/s", 1},
        {"rad", "°", 57.29577951308232},
    };
    if (name.isEmpty() || name == field)
        return 1;
    const double typed = millimetresOf(name, resolution), shown = millimetresOf(field, resolution);
    if (typed > 0 && shown > 0)
        return typed / shown;
    for (const OtherUnit &unit : units)
        if (name == QString::fromUtf8(unit.name) && field == QString::fromUtf8(unit.field))
            return unit.factor;
    return 0;
}

/// A number of digits, points and commas with a decimal point and nothing else. In groups as the language writes them
/// ("1,536.5" in English, "1.536,5" in German) it is read so. Otherwise one point or comma is a decimal one, since
/// hands are used to the key of their keyboard: "1,5" and "0,125" are no groups in English. What has more of them can
/// be read in two ways, so it has no value.
std::optional<QString> plainNumber(const QString &token)
{
    const QString group = QLocale().groupSeparator();
    QString plain = token;
    if (group == QLatin1String(",") || group == QLatin1String(".")) {
        const QString decimal = QLatin1String(group == QLatin1String(",") ? "." : ",");
        const QRegularExpression grouped(
            QStringLiteral("^[1-9]\\d{0,2}(?:\\%1\\d{3})+(?:\\%2\\d*)?$").arg(group, decimal));
        if (grouped.match(token).hasMatch())
            plain.remove(group);
    }
    return plain.count('.') + plain.count(',') > 1 ? std::nullopt : std::optional(plain.replace(',', '.'));
}

/// The text with all its numbers plain.
std::optional<QString> withPlainNumbers(const QString &text)
{
    static const QRegularExpression number(QStringLiteral("[\\d.,]+"));
    QString result;
    qsizetype at = 0;
    for (auto it = number.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        const std::optional<QString> plain = plainNumber(match.captured());
        if (!plain)
            return std::nullopt;
        result += text.mid(at, match.capturedStart() - at) + *plain;
        at = match.capturedEnd();
    }
    return result + text.mid(at);
}

/// The text without units of length behind numbers, each number times what its unit is worth. No value where one is
/// worth nothing.
std::optional<QString> withPlainLengths(const QString &text, const std::function<double(const QString &)> &worth)
{
    static const QRegularExpression length(QStringLiteral("([\\d.]+)(mm|cm|in|pt|px|u)"));
    QString result;
    qsizetype at = 0;
    for (auto it = length.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        const double by = worth(match.captured(2));
        if (by == 0)
            return std::nullopt;
        result += text.mid(at, match.capturedStart() - at) + '(' + match.captured(1) + '*' +
                  QString::number(by, 'g', 17) + ')';
        at = match.capturedEnd();
    }
    return result + text.mid(at);
}

/// The place where the unit at the end begins: behind the last digit, point, comma or bracket.
qsizetype unitStart(const QString &text)
{
    qsizetype end = text.size();
    while (end > 0 && !text[end - 1].isDigit() && !QStringLiteral(".,)").contains(text[end - 1]))
        --end;
    // The "2" of "u²" is no digit, but an "e" may be the end of a broken number.
    return end;
}

QString compact(QString text)
{
    text.replace(QChar(0x2212), '-').replace(QChar(0x00D7), '*').replace(QChar(0x00F7), '/');
    text.remove(QChar(' ')).remove(QChar(0x00A0)).remove(QChar(0x202F)).remove(QChar('\t'));
    return text;
}

bool assigns(const QString &compacted)
{
    return compacted.size() > 1 && compacted[1] == '=' && QString("+-*/").contains(compacted[0]);
}

bool worksOnCurrent(const QString &compacted)
{
    return !compacted.isEmpty() && (assigns(compacted) || QString("+*/").contains(compacted[0]));
}

/// Whether the unit at the end is per cent of what a length is now. Where shares are shown, per cent is the unit
/// itself.
bool isShareOfLength(const QString &name, const QString &field)
{
    return name == QLatin1String("%") && millimetresOf(plainUnit(field), 1) > 0;
}

} // namespace

bool isRelative(const QString &text, const QString &unit)
{
    const QString t = compact(text);
    return worksOnCurrent(t) || isShareOfLength(t.mid(unitStart(t)), unit);
}

QString foreignUnit(const QString &text, const QString &unit, double resolution)
{
    const QString t = compact(text);
    const QString name = t.mid(unitStart(t));
    const bool letters = !name.isEmpty() && (name[0].isLetter() || QString("%°\"'").contains(name[0]));
    const bool isKnown = worthOf(name, unit, resolution) != 0 || isShareOfLength(name, unit);
    return letters && unitStart(t) > 0 && !isKnown ? name : QString();
}

std::optional<double> evaluateArithmetic(const QString &text, std::optional<double> current, const QString &unit,
                                         double resolution)
{
    const QString whole = compact(text);
    const qsizetype end = unitStart(whole);
    std::optional<QString> plain = withPlainNumbers(whole.left(end));
    const bool isShare = isShareOfLength(whole.mid(end), unit);
    if (!plain || plain->isEmpty() || (isShare && !current))
        return std::nullopt;
    const double worth = isShare ? *current / 100 : worthOf(whole.mid(end), unit, resolution);
    if (worth == 0 && !isShare)
        return std::nullopt;
    plain = withPlainLengths(*plain, [&](const QString &name) {
        return isShare ? 0 : worthOf(name, unit, resolution) / worth; // Per cent of what is there go with no length.
    });
    if (!plain)
        return std::nullopt;
    QString t = *plain;
    if (!worksOnCurrent(t)) {
        const std::optional<double> value = Parser(t).whole();
        return value ? std::optional(*value * worth) : std::nullopt;
    }
    if (!current)
        return std::nullopt;
    if (assigns(t))
        t.remove(1, 1);
    const bool sum = t[0] == '+' || t[0] == '-'; // a summand has the unit, a factor only per cent
    const double by = sum ? worth : isShare ? 0.01 : 1;
    if (by != 1)
        t = t[0] + ("((" + t.mid(1) + ")*(" + QString::number(by, 'g', 17) + "))");
    return Parser("(" + QString::number(*current, 'g', 17) + ")" + t).whole();
}

} // namespace suffuse
