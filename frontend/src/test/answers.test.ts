import { expect, test } from 'vitest'

import { asPerson, DESIGNER, PRODUCER } from './account'
import { amendmentAnswers } from './amendments'
import { contractAnswers } from './contract'
import { atDesk } from './desk'
import { inProject } from './project'
import { redlineAnswers } from './redlines'
import { unknownFields } from './schema'

const ANSWERS = {
  producer: asPerson(PRODUCER),
  designer: asPerson(DESIGNER),
  amendments: amendmentAnswers({}),
  contract: contractAnswers(),
  desk: atDesk(),
  project: inProject(),
  redlines: redlineAnswers(),
}

test('a field that the schema does not have is named', () => {
  expect(unknownFields('GET', '/v1/me', 200, { email: 'a@b.example', mail: '', projects: [{ nam: '' }] })).toEqual([
    '.mail',
    '.projects.0.nam',
  ])
})

test.each(Object.entries(ANSWERS))('the answers of %s have the fields of the API alone', (_, answers) => {
  const unknown = Object.entries(answers).flatMap(([asked, answer]) => {
    const [method = '', path = ''] = asked.split(' ')
    const isPlain = typeof answer !== 'function' && !(typeof answer === 'object' && answer !== null && 'body' in answer)
    return isPlain ? unknownFields(method, path, 200, answer).map((field) => `${asked} ${field}`) : []
  })
  expect(unknown).toEqual([])
})
