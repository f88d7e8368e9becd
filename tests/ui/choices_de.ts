<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>tetra::Message</name>
    <message>
        <source>Which.</source>
        <translation>Welche.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Zahlen</translation>
    </message>
</context>
</TS>
