//! A check as JUnit XML: a test for each label of the reference.

use std::borrow::Cow;
use std::path::Path;

use anyhow::Result;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event};

use super::comparison::ComparedLabel;
use campaign::printable::{is_noncharacter, printable};

/// The document about the labels of a reference.
///
/// # Errors
/// Where memory does not take it.
pub fn junit(reference: &Path, compared: &[ComparedLabel]) -> Result<String> {
    let reference = reference.display().to_string();
    let labels = compared.len().to_string();
    let different = compared.iter().filter(|label| label.differs());
    let different = different.count().to_string();
    let counts = [
        ("tests", &*labels),
        ("failures", &different),
        ("errors", "0"),
    ];
    let mut writer = Writer::new_with_indent(Vec::new(), b' ', 2);
    writer.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    begin(
        &mut writer,
        "testsuites",
        &[&[("name", "sweep check")], &counts[..]].concat(),
    )?;
    begin(
        &mut writer,
        "testsuite",
        &[&[("name", &*reference)], &counts[..]].concat(),
    )?;
    for label in compared {
        write_test(&mut writer, &reference, label)?;
    }
    end(&mut writer, "testsuite")?;
    end(&mut writer, "testsuites")?;
    Ok(String::from_utf8(writer.into_inner())? + "\n")
}

/// The document about a check that failed before any label.
///
/// # Errors
/// Where memory does not take it.
pub fn junit_of_error(reference: &Path, error: &str) -> Result<String> {
    let reference = reference.display().to_string();
    let counts = [("tests", "1"), ("failures", "0"), ("errors", "1")];
    let mut writer = Writer::new_with_indent(Vec::new(), b' ', 2);
    writer.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let suites = [&[("name", "sweep check")], &counts[..]].concat();
    begin(&mut writer, "testsuites", &suites)?;
    let suite = [&[("name", &*reference)], &counts[..]].concat();
    begin(&mut writer, "testsuite", &suite)?;
    let name = "labels are checked";
    begin(
        &mut writer,
        "testcase",
        &[("classname", &reference), ("name", name)],
    )?;
    let error = element("error", &[("type", "input"), ("message", error)]);
    writer.write_event(Event::Empty(error))?;
    end(&mut writer, "testcase")?;
    end(&mut writer, "testsuite")?;
    end(&mut writer, "testsuites")?;
    Ok(String::from_utf8(writer.into_inner())? + "\n")
}

type Xml = Writer<Vec<u8>>;

fn write_test(writer: &mut Xml, reference: &str, label: &ComparedLabel) -> Result<()> {
    let motion = label.motion.name();
    let name = format!(
        "case {} by {}, {motion}: {}",
        label.case,
        label.method,
        label.place()
    );
    let line = label.line.to_string();
    let attributes = [
        ("classname", reference),
        ("name", &name),
        ("file", reference),
        ("line", &line),
    ];
    let Some(difference) = label.difference() else {
        let test = element("testcase", &attributes);
        return Ok(writer.write_event(Event::Empty(test))?);
    };
    begin(writer, "testcase", &attributes)?;
    begin(
        writer,
        "failure",
        &[("type", "label"), ("message", &difference)],
    )?;
    let place = format!("{reference}:{line}: {name}: {difference}");
    writer.write_event(Event::Text(BytesText::new(&of_xml(&place))))?;
    end(writer, "failure")?;
    end(writer, "testcase")
}

fn begin(writer: &mut Xml, name: &str, attributes: &[(&str, &str)]) -> Result<()> {
    Ok(writer.write_event(Event::Start(element(name, attributes)))?)
}

fn end(writer: &mut Xml, name: &str) -> Result<()> {
    Ok(writer.write_event(Event::End(BytesEnd::new(name)))?)
}

fn element<'a>(name: &'a str, attributes: &[(&str, &str)]) -> BytesStart<'a> {
    let mut element = BytesStart::new(name);
    for (key, value) in attributes {
        element.push_attribute((*key, &*of_xml(value)));
    }
    element
}

/// A text with what XML has no place for spelt out, or replaced.
fn of_xml(text: &str) -> Cow<'_, str> {
    let text = printable(text);
    if text.contains(is_noncharacter) {
        return Cow::Owned(text.replace(is_noncharacter, "\u{fffd}"));
    }
    text
}
