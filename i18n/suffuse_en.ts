<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Cli</name>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>%n s left</numerusform>
            <numerusform>%n s left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Clipboard</name>
    <message numerus="yes">
        <source>%n stroke(s) cannot lie there, too far out, and were left out.</source>
        <translation>
            <numerusform>%n stroke cannot lie there, too far out, and was left out.</numerusform>
            <numerusform>%n strokes cannot lie there, too far out, and were left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Renderer</name>
    <message numerus="yes">
        <source>%n threads</source>
        <translation>
            <numerusform>%n thread</numerusform>
            <numerusform>%n threads</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::InspectorPanel</name>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n stroke</numerusform>
            <numerusform>%n strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n segment(s)</source>
        <translation>
            <numerusform>%n segment</numerusform>
            <numerusform>%n segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n segment(s)</source>
        <translation>
            <numerusform>%1 of %n segment</numerusform>
            <numerusform>%1 of %n segments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::MainWindow</name>
    <message numerus="yes">
        <source>Name of %n stroke(s)</source>
        <translation>
            <numerusform>Name of %n stroke</numerusform>
            <numerusform>Name of %n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::RecoveryDialog</name>
    <message numerus="yes">
        <source>Discard %n paintings?</source>
        <translation>
            <numerusform>Discard %n painting?</numerusform>
            <numerusform>Discard %n paintings?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesModel</name>
    <message numerus="yes">
        <source>%n segment(s)</source>
        <translation>
            <numerusform>%n segment</numerusform>
            <numerusform>%n segments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::TimelapseDialog</name>
    <message numerus="yes">
        <source>%1; %n second(s) left</source>
        <translation>
            <numerusform>%1; %n second left</numerusform>
            <numerusform>%1; %n seconds left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n minute(s) left</source>
        <translation>
            <numerusform>%1; %n minute left</numerusform>
            <numerusform>%1; %n minutes left</numerusform>
        </translation>
    </message>
</context>
</TS>
