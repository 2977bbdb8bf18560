export function SpecPage() { return <h1>SpecPage</h1> }
